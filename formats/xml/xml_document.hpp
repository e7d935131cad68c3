// An XML text whose elements, attributes and numbers know their place; pugixml stays behind this file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// What a reader of the numbers of an element finds behind the last.
inline constexpr std::string_view kEndOfElement = "end of element";

/// Text of a document, and the mapping of its characters to line and column.
struct DocumentText {
  std::string buffer;  ///< parsed in place: pugixml's pointers are offsets into it
  std::shared_ptr<const TextMap> map;

  std::optional<std::size_t> offset_of(const char* position) const;
};

/// The value of an attribute.
struct Attribute {
  std::string_view value;
  Place place;
};

/// An element. Names are local: `Berkeley:Joint` is `Joint`, whatever the namespace. Views its document.
class Element {
 public:
  Element(pugi::xml_node node, const DocumentText& text) : node_(node), text_(&text) {}

  std::string_view name() const;
  Place place() const;
  std::vector<Element> children() const;
  std::optional<Attribute> attribute(std::string_view name) const;
  /// The words of the element's own text and of all text below it.
  Tokens tokens() const;
  /// The words of an attribute; throws InputError where the element lacks it.
  Tokens attribute_tokens(std::string_view name) const;

 private:
  pugi::xml_node node_;
  const DocumentText* text_;
};

/// A well-formed XML text. No document type definition is loaded, no entity expanded.
class Document {
 public:
  /// Throws InputError at the place where the text stops being well-formed.
  explicit Document(const Source& source);

  Element root() const { return {document_.document_element(), *text_}; }

 private:
  void refuse_second_root() const;

  std::unique_ptr<DocumentText> text_;  // elements point at it: it must not move
  pugi::xml_document document_;
};

}  // namespace keyblock::formats
