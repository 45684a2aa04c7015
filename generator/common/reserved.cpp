#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/identifier.hpp"

namespace treedyn {

namespace {

/// What no identifier may be: keywords of C, C++ and GNU modes (to C++26 and C23), namespace std,
/// and object-like macros of C headers and compilers.
constexpr const char* kWords =
    "ADJ_ESTERROR ADJ_FREQUENCY ADJ_MAXERROR ADJ_MICRO ADJ_NANO ADJ_OFFSET ADJ_OFFSET_SINGLESHOT "
    "ADJ_OFFSET_SS_READ ADJ_SETOFFSET ADJ_STATUS ADJ_TAI ADJ_TICK ADJ_TIMECONST "
    "AIO_PRIO_DELTA_MAX AVR BC_BASE_MAX BC_DIM_MAX BC_SCALE_MAX BC_STRING_MAX BIG_ENDIAN BOOL_MAX "
    "BOOL_WIDTH BUFSIZ BYTE_ORDER CHARCLASS_NAME_MAX CHAR_BIT CHAR_MAX CHAR_MIN CHAR_WIDTH "
    "CLOCKS_PER_SEC CLOCK_BOOTTIME CLOCK_BOOTTIME_ALARM CLOCK_MONOTONIC CLOCK_MONOTONIC_COARSE "
    "CLOCK_MONOTONIC_RAW CLOCK_PROCESS_CPUTIME_ID CLOCK_REALTIME CLOCK_REALTIME_ALARM "
    "CLOCK_REALTIME_COARSE CLOCK_TAI CLOCK_THREAD_CPUTIME_ID COLL_WEIGHTS_MAX DBL_DECIMAL_DIG "
    "DBL_DIG DBL_EPSILON DBL_HAS_SUBNORM DBL_IS_IEC_60559 DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP "
    "DBL_MAX_EXP DBL_MIN DBL_MIN_10_EXP DBL_MIN_EXP DBL_NORM_MAX DBL_SNAN DBL_TRUE_MIN "
    "DEC128_EPSILON DEC128_MANT_DIG DEC128_MAX DEC128_MAX_EXP DEC128_MIN DEC128_MIN_EXP "
    "DEC128_SNAN DEC128_TRUE_MIN DEC32_EPSILON DEC32_MANT_DIG DEC32_MAX DEC32_MAX_EXP DEC32_MIN "
    "DEC32_MIN_EXP DEC32_SNAN DEC32_TRUE_MIN DEC64_EPSILON DEC64_MANT_DIG DEC64_MAX DEC64_MAX_EXP "
    "DEC64_MIN DEC64_MIN_EXP DEC64_SNAN DEC64_TRUE_MIN DECIMAL_DIG DEC_EVAL_METHOD DEC_INFINITY "
    "DEC_NAN DELAYTIMER_MAX E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN "
    "EALREADY EBADE EBADF EBADFD EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD "
    "ECHRNG ECOMM ECONNABORTED ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDOM "
    "EDOTDOT EDQUOT EEXIST EFAULT EFBIG EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS "
    "EINTR EINVAL EIO EISCONN EISDIR EISNAM EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC "
    "EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE "
    "EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO "
    "ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG "
    "ENONET ENOPKG ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY "
    "ENOTNAM ENOTRECOVERABLE ENOTSOCK ENOTSUP ENOTTY ENOTUNIQ ENXIO EOF EOPNOTSUPP EOVERFLOW "
    "EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE "
    "EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE "
    "ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV "
    "EXFULL EXIT_FAILURE EXIT_SUCCESS EXPR_NEST_MAX FD_SETSIZE FILENAME_MAX FLT_DECIMAL_DIG "
    "FLT_DIG FLT_EPSILON FLT_EVAL_METHOD FLT_HAS_SUBNORM FLT_IS_IEC_60559 FLT_MANT_DIG FLT_MAX "
    "FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN FLT_MIN_10_EXP FLT_MIN_EXP FLT_NORM_MAX FLT_RADIX "
    "FLT_ROUNDS FLT_SNAN FLT_TRUE_MIN FOPEN_MAX FP_ILOGB0 FP_ILOGBNAN FP_INFINITE FP_INT_DOWNWARD "
    "FP_INT_TONEAREST FP_INT_TONEARESTFROMZERO FP_INT_TOWARDZERO FP_INT_UPWARD FP_LLOGB0 "
    "FP_LLOGBNAN FP_NAN FP_NORMAL FP_SUBNORMAL FP_ZERO HOST_NAME_MAX HUGE_VAL HUGE_VALF HUGE_VALL "
    "HUGE_VAL_F128 HUGE_VAL_F32 HUGE_VAL_F32X HUGE_VAL_F64 HUGE_VAL_F64X I INFINITY INT16_MAX "
    "INT16_MIN INT16_WIDTH INT32_MAX INT32_MIN INT32_WIDTH INT64_MAX INT64_MIN INT64_WIDTH "
    "INT8_MAX INT8_MIN INT8_WIDTH INTMAX_MAX INTMAX_MIN INTMAX_WIDTH INTPTR_MAX INTPTR_MIN "
    "INTPTR_WIDTH INT_FAST16_MAX INT_FAST16_MIN INT_FAST16_WIDTH INT_FAST32_MAX INT_FAST32_MIN "
    "INT_FAST32_WIDTH INT_FAST64_MAX INT_FAST64_MIN INT_FAST64_WIDTH INT_FAST8_MAX INT_FAST8_MIN "
    "INT_FAST8_WIDTH INT_LEAST16_MAX INT_LEAST16_MIN INT_LEAST16_WIDTH INT_LEAST32_MAX "
    "INT_LEAST32_MIN INT_LEAST32_WIDTH INT_LEAST64_MAX INT_LEAST64_MIN INT_LEAST64_WIDTH "
    "INT_LEAST8_MAX INT_LEAST8_MIN INT_LEAST8_WIDTH INT_MAX INT_MIN INT_WIDTH IOV_MAX "
    "LDBL_DECIMAL_DIG LDBL_DIG LDBL_EPSILON LDBL_HAS_SUBNORM LDBL_IS_IEC_60559 LDBL_MANT_DIG "
    "LDBL_MAX LDBL_MAX_10_EXP LDBL_MAX_EXP LDBL_MIN LDBL_MIN_10_EXP LDBL_MIN_EXP LDBL_NORM_MAX "
    "LDBL_SNAN LDBL_TRUE_MIN LINE_MAX LITTLE_ENDIAN LLONG_MAX LLONG_MIN LLONG_WIDTH "
    "LOGIN_NAME_MAX LONG_BIT LONG_LONG_MAX LONG_LONG_MIN LONG_MAX LONG_MIN LONG_WIDTH L_ctermid "
    "L_cuserid L_tmpnam MATH_ERREXCEPT MATH_ERRNO MAXFLOAT MAX_CANON MAX_INPUT MB_CUR_MAX "
    "MB_LEN_MAX MIPSEB MIPSEL MOD_CLKA MOD_CLKB MOD_ESTERROR MOD_FREQUENCY MOD_MAXERROR MOD_MICRO "
    "MOD_NANO MOD_OFFSET MOD_STATUS MOD_TAI MOD_TIMECONST MQ_PRIO_MAX M_1_PI M_1_PIf M_1_PIf128 "
    "M_1_PIf32 M_1_PIf32x M_1_PIf64 M_1_PIf64x M_1_PIl M_2_PI M_2_PIf M_2_PIf128 M_2_PIf32 "
    "M_2_PIf32x M_2_PIf64 M_2_PIf64x M_2_PIl M_2_SQRTPI M_2_SQRTPIf M_2_SQRTPIf128 M_2_SQRTPIf32 "
    "M_2_SQRTPIf32x M_2_SQRTPIf64 M_2_SQRTPIf64x M_2_SQRTPIl M_E M_Ef M_Ef128 M_Ef32 M_Ef32x "
    "M_Ef64 M_Ef64x M_El M_LN10 M_LN10f M_LN10f128 M_LN10f32 M_LN10f32x M_LN10f64 M_LN10f64x "
    "M_LN10l M_LN2 M_LN2f M_LN2f128 M_LN2f32 M_LN2f32x M_LN2f64 M_LN2f64x M_LN2l M_LOG10E "
    "M_LOG10Ef M_LOG10Ef128 M_LOG10Ef32 M_LOG10Ef32x M_LOG10Ef64 M_LOG10Ef64x M_LOG10El M_LOG2E "
    "M_LOG2Ef M_LOG2Ef128 M_LOG2Ef32 M_LOG2Ef32x M_LOG2Ef64 M_LOG2Ef64x M_LOG2El M_PI M_PI_2 "
    "M_PI_2f M_PI_2f128 M_PI_2f32 M_PI_2f32x M_PI_2f64 M_PI_2f64x M_PI_2l M_PI_4 M_PI_4f "
    "M_PI_4f128 M_PI_4f32 M_PI_4f32x M_PI_4f64 M_PI_4f64x M_PI_4l M_PIf M_PIf128 M_PIf32 M_PIf32x "
    "M_PIf64 M_PIf64x M_PIl M_SQRT1_2 M_SQRT1_2f M_SQRT1_2f128 M_SQRT1_2f32 M_SQRT1_2f32x "
    "M_SQRT1_2f64 M_SQRT1_2f64x M_SQRT1_2l M_SQRT2 M_SQRT2f M_SQRT2f128 M_SQRT2f32 M_SQRT2f32x "
    "M_SQRT2f64 M_SQRT2f64x M_SQRT2l NAME_MAX NAN NFDBITS NGROUPS_MAX NL_ARGMAX NL_LANGMAX "
    "NL_MSGMAX NL_NMAX NL_SETMAX NL_TEXTMAX NULL NZERO PATH_MAX PDP_ENDIAN PIPE_BUF "
    "PTHREAD_DESTRUCTOR_ITERATIONS PTHREAD_KEYS_MAX PTHREAD_STACK_MIN PTRDIFF_MAX PTRDIFF_MIN "
    "PTRDIFF_WIDTH P_tmpdir R3000 R4000 RAND_MAX RENAME_EXCHANGE RENAME_NOREPLACE RENAME_WHITEOUT "
    "RE_DUP_MAX RTSIG_MAX SCHAR_MAX SCHAR_MIN SCHAR_WIDTH SEEK_CUR SEEK_DATA SEEK_END SEEK_HOLE "
    "SEEK_SET SEM_VALUE_MAX SHRT_MAX SHRT_MIN SHRT_WIDTH SIG_ATOMIC_MAX SIG_ATOMIC_MIN "
    "SIG_ATOMIC_WIDTH SIZE_MAX SIZE_WIDTH SNAN SNANF SNANF128 SNANF32 SNANF32X SNANF64 SNANF64X "
    "SNANL SSIZE_MAX STA_CLK STA_CLOCKERR STA_DEL STA_FLL STA_FREQHOLD STA_INS STA_MODE STA_NANO "
    "STA_PLL STA_PPSERROR STA_PPSFREQ STA_PPSJITTER STA_PPSSIGNAL STA_PPSTIME STA_PPSWANDER "
    "STA_RONLY STA_UNSYNC TIMER_ABSTIME TIME_UTC TMP_MAX TTY_NAME_MAX UCHAR_MAX UCHAR_WIDTH "
    "UINT16_MAX UINT16_WIDTH UINT32_MAX UINT32_WIDTH UINT64_MAX UINT64_WIDTH UINT8_MAX "
    "UINT8_WIDTH UINTMAX_MAX UINTMAX_WIDTH UINTPTR_MAX UINTPTR_WIDTH UINT_FAST16_MAX "
    "UINT_FAST16_WIDTH UINT_FAST32_MAX UINT_FAST32_WIDTH UINT_FAST64_MAX UINT_FAST64_WIDTH "
    "UINT_FAST8_MAX UINT_FAST8_WIDTH UINT_LEAST16_MAX UINT_LEAST16_WIDTH UINT_LEAST32_MAX "
    "UINT_LEAST32_WIDTH UINT_LEAST64_MAX UINT_LEAST64_WIDTH UINT_LEAST8_MAX UINT_LEAST8_WIDTH "
    "UINT_MAX UINT_WIDTH ULLONG_MAX ULLONG_WIDTH ULONG_LONG_MAX ULONG_MAX ULONG_WIDTH USHRT_MAX "
    "USHRT_WIDTH WCHAR_MAX WCHAR_MIN WCHAR_WIDTH WCONTINUED WEXITED WIN32 WIN64 WINNT WINT_MAX "
    "WINT_MIN WINT_WIDTH WNOHANG WNOWAIT WORD_BIT WSTOPPED WUNTRACED XATTR_LIST_MAX "
    "XATTR_NAME_MAX XATTR_SIZE_MAX alignas alignof and and_eq asm atomic_cancel atomic_commit "
    "atomic_noexcept auto bitand bitor bool break case catch char char16_t char32_t char8_t class "
    "co_await co_return co_yield compl complex concept const const_cast consteval constexpr "
    "constinit continue contract_assert decltype default delete do double dynamic_cast else enum "
    "errno explicit export extern false far float for fortran friend goto i386 if imaginary "
    "inline int linux long math_errhandling mc68000 mc68020 mips mutable namespace near new "
    "noexcept noreturn not not_eq nullptr operator or or_eq private protected public register "
    "reinterpret_cast requires restrict return short signed sizeof sparc static static_assert "
    "static_cast std stderr stdin stdout struct switch synchronized template this thread_local "
    "throw true try typedef typeid typename typeof typeof_unqual union unix unsigned using "
    "virtual void volatile wchar_t while xor xor_eq ";

/// What a namespace or a local must avoid besides: functions, types and function-like macros that
/// C headers put into the global namespace; without those that end in f32, f64x, ...
constexpr const char* kNames =
    "CMPLX CMPLXF CMPLXL FD_CLR FD_ISSET FD_SET FD_ZERO FILE INT16_C INT32_C INT64_C INT8_C "
    "INTMAX_C OVERFLOW SIGINT SIGTERM UINT16_C UINT32_C UINT64_C UINT8_C UINTMAX_C UNDERFLOW "
    "WEXITSTATUS WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED WSTOPSIG WTERMSIG a64l abort abs "
    "acos acosf acosh acoshf acoshl acosl aligned_alloc alloca arc4random arc4random_buf "
    "arc4random_uniform asctime asctime_r asin asinf asinh asinhf asinhl asinl asprintf assert "
    "assert_perror at_quick_exit atan atan2 atan2f atan2l atanf atanh atanhf atanhl atanl atexit "
    "atof atoi atol atoll basename bcmp bcopy be16toh be32toh be64toh blkcnt64_t blkcnt_t "
    "blksize_t bsearch bzero caddr_t calloc canonicalize canonicalize_file_name canonicalizef "
    "canonicalizel cbrt cbrtf cbrtl ceil ceilf ceill clearenv clearerr clearerr_unlocked clock "
    "clock_adjtime clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime "
    "clock_t clockid_t comparison_fn_t cookie_close_function_t cookie_io_functions_t "
    "cookie_read_function_t cookie_seek_function_t cookie_write_function_t copysign copysignf "
    "copysignl cos cosf cosh coshf coshl cosl ctermid ctime ctime_r cuserid daddl daddr_t "
    "daylight ddivl dev_t dfmal difftime div div_t dmull double_t dprintf drand48 drand48_data "
    "drand48_r drem dremf dreml dsqrtl dsubl dysize ecvt ecvt_r epsilon erand48 erand48_r erf "
    "erfc erfcf erfcl erff erfl error_t exit exp exp10 exp10f exp10l exp2 exp2f exp2l expf expl "
    "explicit_bzero expm1 expm1f expm1l f32addf128 f32addf32x f32addf64 f32addf64x f32divf128 "
    "f32divf32x f32divf64 f32divf64x f32fmaf128 f32fmaf32x f32fmaf64 f32fmaf64x f32mulf128 "
    "f32mulf32x f32mulf64 f32mulf64x f32sqrtf128 f32sqrtf32x f32sqrtf64 f32sqrtf64x f32subf128 "
    "f32subf32x f32subf64 f32subf64x f32xaddf128 f32xaddf64 f32xaddf64x f32xdivf128 f32xdivf64 "
    "f32xdivf64x f32xfmaf128 f32xfmaf64 f32xfmaf64x f32xmulf128 f32xmulf64 f32xmulf64x "
    "f32xsqrtf128 f32xsqrtf64 f32xsqrtf64x f32xsubf128 f32xsubf64 f32xsubf64x f64addf128 "
    "f64addf64x f64divf128 f64divf64x f64fmaf128 f64fmaf64x f64mulf128 f64mulf64x f64sqrtf128 "
    "f64sqrtf64x f64subf128 f64subf64x f64xaddf128 f64xdivf128 f64xfmaf128 f64xmulf128 "
    "f64xsqrtf128 f64xsubf128 fabs fabsf fabsl fadd faddl fclose fcloseall fcvt fcvt_r fd_mask "
    "fd_set fdim fdimf fdiml fdiv fdivl fdopen feof feof_unlocked ferror ferror_unlocked fflush "
    "fflush_unlocked ffma ffmal ffs ffsl ffsll fgetc fgetc_unlocked fgetpos fgetpos64 fgets "
    "fgets_unlocked fileno fileno_unlocked finite finitef finitel float_t flockfile floor floorf "
    "floorl fma fmaf fmal fmax fmaxf fmaximum fmaximum_mag fmaximum_mag_num fmaximum_mag_numf "
    "fmaximum_mag_numl fmaximum_magf fmaximum_magl fmaximum_num fmaximum_numf fmaximum_numl "
    "fmaximumf fmaximuml fmaxl fmaxmag fmaxmagf fmaxmagl fmemopen fmin fminf fminimum "
    "fminimum_mag fminimum_mag_num fminimum_mag_numf fminimum_mag_numl fminimum_magf "
    "fminimum_magl fminimum_num fminimum_numf fminimum_numl fminimumf fminimuml fminl fminmag "
    "fminmagf fminmagl fmod fmodf fmodl fmul fmull fopen fopen64 fopencookie fpclassify fpos64_t "
    "fpos_t fprintf fputc fputc_unlocked fputs fputs_unlocked fread fread_unlocked free freopen "
    "freopen64 frexp frexpf frexpl fromfp fromfpf fromfpl fromfpx fromfpxf fromfpxl fsblkcnt64_t "
    "fsblkcnt_t fscanf fseek fseeko fseeko64 fsetpos fsetpos64 fsfilcnt64_t fsfilcnt_t fsid_t "
    "fsqrt fsqrtl fsub fsubl ftell ftello ftello64 ftrylockfile funlockfile fwrite "
    "fwrite_unlocked gamma gammaf gammal gcvt getc getc_unlocked getchar getchar_unlocked getdate "
    "getdate_err getdate_r getdelim getenv getline getloadavg getpayload getpayloadf getpayloadl "
    "getpt gets getsubopt getw gid_t gmtime gmtime_r grantpt htobe16 htobe32 htobe64 htole16 "
    "htole32 htole64 hypot hypotf hypotl id_t ilogb ilogbf ilogbl index initstate initstate_r "
    "ino64_t ino_t int16_t int32_t int64_t int8_t int_fast16_t int_fast32_t int_fast64_t "
    "int_fast8_t int_least16_t int_least32_t int_least64_t int_least8_t intmax_t intptr_t isalnum "
    "isalpha iscanonical isdigit iseqsig isfinite isgreater isgreaterequal isinf isinff isinfl "
    "isless islessequal islessgreater islower isnan isnanf isnanl isnormal isprint issignaling "
    "isspace issubnormal isunordered isupper iszero itimerspec j0 j0f j0l j1 j1f j1l jn jnf jnl "
    "jrand48 jrand48_r key_t l64a labs lcong48 lcong48_r ldexp ldexpf ldexpl ldiv ldiv_t le16toh "
    "le32toh le64toh lerp lgamma lgamma_r lgammaf lgammaf_r lgammal lgammal_r link llabs lldiv "
    "lldiv_t llogb llogbf llogbl llrint llrintf llrintl llround llroundf llroundl locale_t "
    "localtime localtime_r loff_t log log10 log10f log10l log1p log1pf log1pl log2 log2f log2l "
    "logb logbf logbl logf logl longjmp lrand48 lrand48_r lrint lrintf lrintl lround lroundf "
    "lroundl main malloc max_align_t mblen mbstowcs mbtowc memccpy memchr memcmp memcpy memfrob "
    "memmem memmove mempcpy memrchr memset mkdtemp mkostemp mkostemp64 mkostemps mkostemps64 "
    "mkstemp mkstemp64 mkstemps mkstemps64 mktemp mktime mode_t modf modff modfl mrand48 "
    "mrand48_r nan nanf nanl nanosleep nearbyint nearbyintf nearbyintl nextafter nextafterf "
    "nextafterl nextdown nextdownf nextdownl nexttoward nexttowardf nexttowardl nextup nextupf "
    "nextupl nlink_t nrand48 nrand48_r nullptr_t obstack obstack_printf obstack_vprintf off64_t "
    "off_t offsetof on_exit open_memstream pclose perror pid_t popen posix_memalign posix_openpt "
    "pow powf powl printf program_invocation_name program_invocation_short_name pselect "
    "pthread_attr_t pthread_barrier_t pthread_barrierattr_t pthread_cond_t pthread_condattr_t "
    "pthread_key_t pthread_mutex_t pthread_mutexattr_t pthread_once_t pthread_rwlock_t "
    "pthread_rwlockattr_t pthread_spinlock_t pthread_t ptrdiff_t ptsname ptsname_r putc "
    "putc_unlocked putchar putchar_unlocked putenv puts putw qecvt qecvt_r qfcvt qfcvt_r qgcvt "
    "qsort qsort_r quad_t quick_exit raise rand rand_r random random_data random_r rawmemchr "
    "realloc reallocarray realpath register_t remainder remainderf remainderl remove remquo "
    "remquof remquol rename renameat renameat2 rewind rindex rint rintf rintl round roundeven "
    "roundevenf roundevenl roundf roundl rpmatch scalb scalbf scalbl scalbln scalblnf scalblnl "
    "scalbn scalbnf scalbnl scanf secure_getenv seed48 seed48_r select setbuf setbuffer setenv "
    "setjmp setlinebuf setpayload setpayloadf setpayloadl setpayloadsig setpayloadsigf "
    "setpayloadsigl setstate setstate_r setvbuf sigabbrev_np sigdescr_np sigevent signal signals "
    "signbit signgam significand significandf significandl sigset_t sin sincos sincosf sincosl "
    "sinf sinh sinhf sinhl sinl size_t slots snprintf sprintf sqrt sqrtf sqrtl srand srand48 "
    "srand48_r srandom srandom_r sscanf ssize_t stpcpy stpncpy strcasecmp strcasecmp_l strcasestr "
    "strcat strchr strchrnul strcmp strcoll strcoll_l strcpy strcspn strdup strdupa strerror "
    "strerror_l strerrordesc_np strerrorname_np strfromd strfromf strfromf128 strfromf32 "
    "strfromf32x strfromf64 strfromf64x strfroml strfry strftime strftime_l strlen strncasecmp "
    "strncasecmp_l strncat strncmp strncpy strndup strndupa strnlen strpbrk strptime strptime_l "
    "strrchr strsep strsignal strspn strstr strtod strtod_l strtof strtof128 strtof128_l strtof32 "
    "strtof32_l strtof32x strtof32x_l strtof64 strtof64_l strtof64x strtof64x_l strtof_l strtok "
    "strtol strtol_l strtold strtold_l strtoll strtoll_l strtoq strtoul strtoul_l strtoull "
    "strtoull_l strtouq strverscmp strxfrm strxfrm_l suseconds_t system tan tanf tanh tanhf tanhl "
    "tanl tempnam tgamma tgammaf tgammal time time_t timegm timelocal timer_create timer_delete "
    "timer_getoverrun timer_gettime timer_settime timer_t timespec timespec_get timespec_getres "
    "timeval timex timezone tm tmpfile tmpfile64 tmpnam tolower totalorder totalorderf "
    "totalorderl totalordermag totalordermagf totalordermagl toupper trunc truncf truncl tzname "
    "tzset u_char u_int u_int16_t u_int32_t u_int64_t u_int8_t u_long u_quad_t u_short ufromfp "
    "ufromfpf ufromfpl ufromfpx ufromfpxf ufromfpxl uid_t uint uint16_t uint32_t uint64_t uint8_t "
    "uint_fast16_t uint_fast32_t uint_fast64_t uint_fast8_t uint_least16_t uint_least32_t "
    "uint_least64_t uint_least8_t uintmax_t uintptr_t ulong ungetc unlockpt unsetenv useconds_t "
    "ushort va_arg va_copy va_end va_list va_start valloc vasprintf vdprintf vfprintf vfscanf "
    "vprintf vscanf vsnprintf vsprintf vsscanf wcstombs wctomb wint_t y0 y0f y0l y1 y1f y1l yn "
    "ynf ynl zeta ";

using Words = std::set<std::string, std::less<>>;

Words set_of(std::string_view text) {
  const std::vector<std::string> words = words_in(text);
  return {words.begin(), words.end()};
}

/// "acos" of "acosf64x": functions of every floating-point type of the compiler.
std::string_view without_type(std::string_view name) {
  name = name.ends_with("_r") ? name.substr(0, name.size() - 2) : name;  // lgammaf64_r
  constexpr std::array<std::string_view, 5> kTypes = {"f32", "f32x", "f64", "f64x", "f128"};
  const auto* const type =
      std::ranges::find_if(kTypes, [&](std::string_view t) { return name.ends_with(t); });
  return type == kTypes.end() ? name : name.substr(0, name.size() - type->size());
}

}  // namespace

bool is_reserved_word(std::string_view name) {
  static const Words words = set_of(kWords);
  return words.contains(name);
}

bool is_reserved(std::string_view name) {
  static const Words names = set_of(kNames);
  return is_reserved_word(name) || names.contains(name) || names.contains(without_type(name));
}

}  // namespace treedyn
