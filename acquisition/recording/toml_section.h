// A TOML file's tables, with the place of each for what is to be said of it.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace searig::acquisition {

/// One table of a TOML file, its place in the file and what to say of a wrong key in it. What is
/// wrong throws InputError: one sentence with file and line.
class Section {
 public:
  Section(const std::filesystem::path& file, std::string name, const toml::table& table)
      : file_(file), name_(std::move(name)), table_(table) {}

  const toml::table& table() const { return table_; }
  const std::filesystem::path& file() const { return file_; }
  const std::string& name() const { return name_; }

  [[noreturn]] void refuse(const toml::node* node, const std::string& what) const;

  std::string key(std::string_view of) const { return name_ + "." + std::string(of); }

  // Nothing where there is no such key.
  std::optional<double> number(std::string_view of) const;
  std::optional<double> positive(std::string_view of) const;
  std::optional<double> nonzero(std::string_view of) const;
  std::optional<std::string> text(std::string_view of) const;

  Section section(std::string_view of) const;

 private:
  std::filesystem::path file_;
  std::string name_;
  const toml::table& table_;
};

/// Throws InputError with file, line and column.
toml::table parse_toml(const std::filesystem::path& file);

}  // namespace searig::acquisition
