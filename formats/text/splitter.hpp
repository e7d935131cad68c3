// Finds the starts and ends of the words of a text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace keyblock::formats {

enum class Syntax {
  native,  ///< white space and commas separate; `#` `%` `!` `;` `//` start a comment to the end of the line
  xml,     ///< white space, commas and semicolons separate; no comments (dropped by the XML reader)
};

/// Role of a character between words. A slash is ordinary unless a second follows.
enum class Role : unsigned char { ordinary, separator, comment, slash };
using Roles = std::array<Role, 256>;

constexpr Roles roles_of(Syntax syntax) {
  constexpr char kDosEndOfFile = 0x1a;
  Roles roles{};
  const auto set = [&](std::string_view characters, Role role) {
    for (const char c : characters) roles[static_cast<unsigned char>(c)] = role;
  };
  set(" \t,\v\f\n\r", Role::separator);
  roles[kDosEndOfFile] = Role::separator;
  if (syntax == Syntax::xml) {
    set(";", Role::separator);
    roles[0] = Role::separator;  // the XML reader ends each piece with it, in place
  } else {
    set("#%!;", Role::comment);
    set("/", Role::slash);
  }
  return roles;
}

inline constexpr Roles kNativeRoles = roles_of(Syntax::native);
inline constexpr Roles kXmlRoles = roles_of(Syntax::xml);

constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// Finds the words of a text one after another.
class Splitter {
 public:
  Splitter(std::string_view text, Syntax syntax) : Splitter(text, syntax == Syntax::xml ? kXmlRoles : kNativeRoles) {}
  /// `roles` must outlive the object.
  Splitter(std::string_view text, const Roles& roles) : text_(text), roles_(roles) {}

  /// Returns the start of the first word from `at` on; the end of the text if no word follows.
  std::size_t word_start(std::size_t at) const {
    for (; at < text_.size(); ++at) {
      const Role role = role_at(at);
      if (role == Role::ordinary) return at;
      if (role != Role::comment) continue;
      while (at + 1 < text_.size() && !is_line_end(text_[at + 1])) ++at;
    }
    return at;
  }

  bool is_end(std::size_t at) const { return at == text_.size() || role_at(at) != Role::ordinary; }

  std::size_t word_end(std::size_t at) const {
    while (!is_end(at)) ++at;
    return at;
  }

  /// Returns ordinary, separator or comment.
  Role role_at(std::size_t at) const {
    const Role role = roles_[static_cast<unsigned char>(text_[at])];
    if (role != Role::slash) return role;
    return at + 1 < text_.size() && text_[at + 1] == '/' ? Role::comment : Role::ordinary;
  }

 private:
  std::string_view text_;
  const Roles& roles_;
};

}  // namespace keyblock::formats
