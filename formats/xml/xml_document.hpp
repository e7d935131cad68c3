// Reads an XML text whose elements, attributes and numbers know their place; hides pugixml.
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

/// Name for the end of the numbers of an element, in messages.
inline constexpr std::string_view kEndOfElement = "end of element";

/// Text of a document, and the conversion of its characters to line and column.
struct DocumentText {
  std::string buffer;  ///< parsed in place: pugixml's pointers are offsets into it
  std::shared_ptr<const TextMap> map;

  std::optional<std::size_t> offset_of(const char* position) const;
};

/// Value of an attribute.
struct Attribute {
  std::string_view value;
  Place place;
};

/// Element of a document. Names are local: `Berkeley:Joint` is `Joint` in any namespace. Refers to its document.
class Element {
 public:
  Element(pugi::xml_node node, const DocumentText& text) : node_(node), text_(&text) {}

  std::string_view name() const;
  Place place() const;
  std::vector<Element> children() const;
  std::optional<Attribute> attribute(std::string_view name) const;
  /// Returns the words of the element's own text and of all text below it.
  Tokens tokens() const;
  /// Returns the words of an attribute. Throws InputError if the element lacks it.
  Tokens attribute_tokens(std::string_view name) const;

 private:
  pugi::xml_node node_;
  const DocumentText* text_;
};

/// Well-formed XML text. No document type definition is loaded, no entity expanded.
class Document {
 public:
  /// Throws InputError at the place where the text stops being well-formed.
  explicit Document(const Source& source);

  Element root() const { return {document_.document_element(), *text_}; }

 private:
  void refuse_second_root() const;

  std::unique_ptr<DocumentText> text_;  // elements refer to it: it must not move
  pugi::xml_document document_;
};

}  // namespace keyblock::formats
