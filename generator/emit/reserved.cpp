#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "emit/names.hpp"

namespace treedyn::emit {

namespace {

// Keywords of C++, and macros, functions and types of the C standard library.
constexpr const char* kReserved =
    "BUFSIZ CHAR_BIT CLOCKS_PER_SEC DBL_EPSILON DBL_MAX DBL_MIN EDOM EOF ERANGE EXIT_FAILURE "
    "EXIT_SUCCESS FILENAME_MAX FLT_EPSILON FLT_MAX FLT_MIN FOPEN_MAX FP_INFINITE FP_NAN "
    "FP_NORMAL FP_SUBNORMAL FP_ZERO HUGE_VAL HUGE_VALF HUGE_VALL I INFINITY INT_MAX INT_MIN "
    "LONG_MAX LONG_MIN MATH_ERREXCEPT MATH_ERRNO MAXFLOAT M_1_PI M_1_PIl M_2_PI M_2_PIl "
    "M_2_SQRTPI M_2_SQRTPIl M_E M_El M_LN10 M_LN10l M_LN2 M_LN2l M_LOG10E M_LOG10El M_LOG2E "
    "M_LOG2El M_PI M_PI_2 M_PI_2l M_PI_4 M_PI_4l M_PIl M_SQRT1_2 M_SQRT1_2l M_SQRT2 M_SQRT2l "
    "NAN NULL OVERFLOW RAND_MAX SEEK_CUR SEEK_END SEEK_SET SIGINT SIGTERM UINT_MAX UNDERFLOW "
    "abort abs acos acosh alignas aligned_alloc alignof and and_eq asctime asin asinh asm "
    "assert at_quick_exit atan atan2 atanh atexit atof atoi atol atoll atomic_cancel "
    "atomic_commit atomic_noexcept auto bitand bitor bool break bsearch calloc case catch "
    "cbrt ceil char char16_t char32_t char8_t class clock clock_t co_await co_return "
    "co_yield compl complex concept const const_cast consteval constexpr constinit continue "
    "copysign cos cosh ctime decltype default delete difftime div div_t do double double_t "
    "drem dynamic_cast else enum erf erfc errno exit exp exp10 exp2 explicit expm1 export "
    "extern fabs false fclose fdim feof ferror fflush fgetc fgets finite float float_t floor "
    "fma fmax fmin fmod fopen for fpos_t fprintf fputc fputs fread free freopen frexp friend "
    "fscanf fseek ftell fwrite gamma getc getchar getenv gets gmtime goto hypot if ilogb "
    "imaginary index inline int int16_t int32_t int64_t int8_t intptr_t isalnum isalpha "
    "isdigit isinf islower isnan isprint isspace isupper j0 j1 jn labs ldexp ldiv lgamma "
    "link linux llabs llrint llround localtime log log10 log1p log2 logb long longjmp lrint "
    "lround main malloc math_errhandling max_align_t memchr memcmp memcpy memmove memset "
    "mktime modf mutable namespace nan nearbyint new nextafter nexttoward noexcept not "
    "not_eq nullptr offsetof on_exit operator or or_eq perror pow printf private protected "
    "ptrdiff_t public putc putchar puts qsort quick_exit raise rand random realloc register "
    "reinterpret_cast remainder remove remquo rename requires return rewind rindex rint "
    "round scalb scalbn scanf select setbuf setjmp short signal signals signed signgam "
    "significand sin sincos sinh size_t sizeof slots snprintf sprintf sqrt srand sscanf "
    "static static_assert static_cast std stderr stdin stdout strcat strchr strcmp strcpy "
    "strlen strncpy strstr strtod strtok strtol struct switch synchronized system tan tanh "
    "template tgamma this thread_local throw time time_t tm tmpfile tmpnam tolower toupper "
    "true trunc try typedef typeid typename typeof uint16_t uint32_t uint64_t uint8_t "
    "uintptr_t ungetc union unix unsigned using va_arg va_copy va_end va_list va_start "
    "virtual void volatile vprintf wchar_t while wint_t xor xor_eq y0 y1 yn ";

std::set<std::string, std::less<>> split(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string, std::less<>> words;
  for (std::string word; stream >> word;) {
    words.insert(word);
  }
  return words;
}

}  // namespace

bool is_reserved(std::string_view name) {
  static const std::set<std::string, std::less<>> words = split(kReserved);
  return words.contains(name);
}

}  // namespace treedyn::emit
