// Parses in place, so that every name and value of pugixml is an offset into the text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/xml/xml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <new>

#include "formats/text/decimal_comma.hpp"
#include "formats/text/split.hpp"

namespace keyblock::formats {
namespace {

/// Line ends and references stay unchanged: nothing moves within the buffer, so offsets stay valid.
constexpr unsigned kParseFlags = pugi::parse_cdata;

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(':') + 1);  // npos + 1 is 0
}

/// pugixml stops one character before the end of an incomplete text.
[[noreturn]] void refuse(const DocumentText& text, const pugi::xml_parse_result& result) {
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();  // no fault of the file
  const std::size_t size = text.buffer.size();
  const auto offset = static_cast<std::size_t>(result.offset);
  if (offset + 1 >= size) throw InputError(text.map->place(size), "expected well-formed XML, found end of file");
  throw InputError(text.map->place(offset),
                   fmt::format("expected well-formed XML, found a fault: {}", result.description()));
}

/// Bounds the memory of pugixml for a text: one node per element and one per text after any tag, one attribute per
/// equals sign.
std::size_t most_bytes(std::string_view text) {
  constexpr std::size_t kNode = 64, kAttribute = 40;
  std::size_t nodes = 0, attributes = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '<';
    if ((text[i] == '<' && next != '/') || (text[i] == '>' && next != '<')) ++nodes;
    if (text[i] == '=') ++attributes;
  }
  return kNode * nodes + kAttribute * attributes;
}

/// Files of Berkeley's programs need 2 to 8 bytes per byte; a file of almost only tags would need 32.
void refuse_tags_only(const Source& source) {
  constexpr std::size_t kMostBytesAByte = 12, kAtLeast = 1 << 16;
  if (most_bytes(source.text) > kMostBytesAByte * source.text.size() + kAtLeast)
    throw InputError({source.name}, "expected an XML file with values, found almost nothing but tags");
}

/// pugixml accepts them; XML permits each attribute of an element once.
void refuse_repeated_attributes(const pugi::xml_node root, const DocumentText& text) {
  pugi::xml_node node = root;
  while (node) {
    std::vector<std::string_view> names;
    for (const pugi::xml_attribute attribute : node.attributes()) names.emplace_back(attribute.name());
    std::ranges::stable_sort(names);
    if (const auto twice = std::ranges::adjacent_find(names); twice != names.end())
      throw InputError(text.map->place(text.offset_of((twice + 1)->data()).value_or(0)),
                       fmt::format("expected each attribute of {} once, found {} again", node.name(), *twice));
    pugi::xml_node next = node.first_child();
    for (; !next && node != root; node = node.parent()) next = node.next_sibling();
    node = next;
  }
}

}  // namespace

std::optional<std::size_t> DocumentText::offset_of(const char* position) const {
  const char* begin = buffer.data();
  if (std::less<>{}(position, begin) || std::less<>{}(begin + buffer.size(), position)) return std::nullopt;
  return static_cast<std::size_t>(position - begin);
}

Document::Document(const Source& source) {
  const std::string_view text = without_bom(source.text);
  refuse_tags_only(source);
  text_ = std::make_unique<DocumentText>(DocumentText{std::string(text), std::make_shared<TextMap>(source.name, text)});
  const pugi::xml_parse_result result =
      document_.load_buffer_inplace(text_->buffer.data(), text_->buffer.size(), kParseFlags, pugi::encoding_utf8);
  if (!result) refuse(*text_, result);
  refuse_second_root();
  for (const pugi::xml_node node : document_.children()) refuse_repeated_attributes(node, *text_);
}

void Document::refuse_second_root() const {
  for (pugi::xml_node node = document_.document_element().next_sibling(); node; node = node.next_sibling())
    if (node.type() == pugi::node_element)
      throw InputError(Element(node, *text_).place(),
                       fmt::format("expected one root element, found a second, {}", Element(node, *text_).name()));
}

std::string_view Element::name() const {
  return local_name(node_.name());
}

Place Element::place() const {
  return text_->map->place(text_->offset_of(node_.name()).value_or(0));
}

std::vector<Element> Element::children() const {
  std::vector<Element> elements;
  for (const pugi::xml_node child : node_.children())
    if (child.type() == pugi::node_element) elements.emplace_back(child, *text_);
  return elements;
}

std::optional<Attribute> Element::attribute(std::string_view name) const {
  for (const pugi::xml_attribute attribute : node_.attributes()) {
    if (local_name(attribute.name()) != name) continue;
    const auto offset = text_->offset_of(attribute.value());
    return Attribute{attribute.value(), offset ? text_->map->place(*offset) : place()};
  }
  return std::nullopt;
}

Tokens Element::tokens() const {
  Tokens tokens{text_->map, text_->buffer, Syntax::xml, text_->offset_of(node_.name()).value_or(0)};
  pugi::xml_node node = node_.first_child();
  while (node) {
    const std::string_view value = node.value();
    if (const auto offset = text_->offset_of(node.value()); offset && node.type() != pugi::node_element) {
      add_words(tokens, *offset, value.size());
      tokens.end = *offset + value.size();
    }
    pugi::xml_node next = node.first_child();
    for (; !next && node != node_; node = node.parent()) next = node.next_sibling();
    node = next;
  }
  return tokens;
}

Tokens Element::attribute_tokens(std::string_view name) const {
  const auto found = attribute(name);
  if (!found) throw InputError(place(), fmt::format("expected the attribute {} of {}, found none", name, this->name()));
  const std::size_t offset = text_->offset_of(found->value.data()).value_or(0);
  refuse_decimal_commas(*text_->map, text_->buffer, offset, found->value.size());
  Tokens tokens{text_->map, text_->buffer, Syntax::xml, offset + found->value.size()};
  add_words(tokens, offset, found->value.size());
  return tokens;
}

}  // namespace keyblock::formats
