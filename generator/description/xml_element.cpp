#include "description/xml_element.hpp"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

namespace treedyn::description {

namespace {

constexpr std::size_t kMostNestedElements = 64;
constexpr std::size_t kMaxElements = 1'000'000;  // that are kept
constexpr std::size_t kMaxStrays = 1000;

/// `text` with what urdfdom's parser tolerates and XML does not made spaces: "--" and bytes beyond
/// ASCII inside of comments. Places stay as they are.
std::string tolerated(std::string text) {
  std::size_t start = text.find("<!--");
  while (start != std::string::npos) {
    const std::size_t end = text.find("-->", start + 4);
    if (end == std::string::npos) {
      break;
    }
    for (std::size_t k = start + 4; k < end; ++k) {
      const bool odd = text[k] == '-' || static_cast<unsigned char>(text[k]) >= 0x80;
      text[k] = odd ? ' ' : text[k];
    }
    start = text.find("<!--", end);
  }
  return text;
}

/// Builds the elements with a stack of its own. A mistake stops expat and is thrown after it has
/// returned, for exceptions must not cross C code.
class ElementBuilder {
 public:
  ElementBuilder(const std::string& file, Wanted wanted)
      : file_(file), wanted_(wanted), parser_(XML_ParserCreate(nullptr)) {
    TREEDYN_EXPECT(parser_ != nullptr);
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
  }

  Element parse(const std::string& original) {
    const std::string text = tolerated(original);
    const auto size = static_cast<int>(text.size());
    const XML_Status status = XML_Parse(parser_.get(), text.data(), size, XML_TRUE);
    if (problem_) {
      throw InputError(where_.in(file_), *problem_);
    }
    if (status != XML_STATUS_OK) {
      const Place where = here();
      const XML_Error error = XML_GetErrorCode(parser_.get());
      throw InputError(where.in(file_), fmt::format("{}; expected {}", XML_ErrorString(error),
                                                    error == XML_ERROR_UNKNOWN_ENCODING
                                                        ? "UTF-8, UTF-16, ISO-8859-1 or US-ASCII"
                                                        : "XML"));
    }
    return std::move(root_);
  }

 private:
  static ElementBuilder& self(void* data) { return *static_cast<ElementBuilder*>(data); }
  static void on_start(void* data, const XML_Char* name, const XML_Char** attributes) {
    self(data).start(name, attributes);
  }
  static void on_end(void* data, const XML_Char*) { self(data).end(); }
  static void on_text(void* data, const XML_Char* text, int size) {
    self(data).note({text, static_cast<std::size_t>(size)});
  }
  static void on_doctype(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    self(data).stop("document type declarations are not supported; expected <robot>");
  }

  [[nodiscard]] Place here() const {
    return {static_cast<int>(XML_GetCurrentLineNumber(parser_.get())),
            static_cast<int>(XML_GetCurrentColumnNumber(parser_.get())) + 1};
  }

  void stop(const std::string& message) {
    if (!problem_) {
      problem_ = message;
      where_ = here();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  void start(const XML_Char* name, const XML_Char** attributes) {
    if (open_.size() + skipped_ == kMostNestedElements) {
      stop(fmt::format("nested too deeply; expected at most {} levels", kMostNestedElements));
    } else if (skipped_ > 0 || (!open_.empty() && !wanted_(open_.back().name, name))) {
      if (skipped_ == 0 && strays_ < kMaxStrays) {
        ++strays_;
        open_.back().strays.push_back({name, here()});
      }
      ++skipped_;
    } else if (++elements_ > kMaxElements) {
      stop(fmt::format("too many elements; expected at most {}", kMaxElements));
    } else {
      Element element;
      element.name = name;
      element.where = here();
      for (const XML_Char** a = attributes; *a != nullptr; a += 2) {
        element.attributes.emplace_back(a[0], a[1]);
      }
      open_.push_back(std::move(element));
    }
  }

  void note(std::string_view text) {
    if (!problem_ && skipped_ == 0 && open_.back().text.line == 0 &&
        text.find_first_not_of(" \t\r\n") != text.npos) {
      open_.back().text = here();
    }
  }

  void end() {
    if (problem_) {
      return;
    }
    if (skipped_ > 0) {
      --skipped_;
      return;
    }
    Element element = std::move(open_.back());
    open_.pop_back();
    if (open_.empty()) {
      root_ = std::move(element);
    } else {
      open_.back().children.push_back(std::move(element));
    }
  }

  const std::string& file_;
  Wanted wanted_;
  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };
  std::unique_ptr<XML_ParserStruct, Free> parser_;
  std::vector<Element> open_;
  std::size_t skipped_ = 0;  ///< levels below the last element that is kept
  std::size_t elements_ = 0;
  std::size_t strays_ = 0;
  Element root_;
  std::optional<std::string> problem_;
  Place where_;
};

}  // namespace

const std::string* Element::attribute(std::string_view key) const {
  const auto found =
      std::ranges::find_if(attributes, [key](const auto& a) { return a.first == key; });
  return found == attributes.end() ? nullptr : &found->second;
}

Element parse_xml(const std::string& text, const std::string& file, Wanted wanted) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError({file, 1, 1}, "file is empty; expected a robot description");
  }
  return ElementBuilder(file, wanted).parse(text);
}

}  // namespace treedyn::description
