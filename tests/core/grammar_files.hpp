// The texts of the shelf, as files.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace panicle::tests {

// Those of a model, by their names.
inline std::vector<std::filesystem::path> grammar_files(const std::string& model) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(PANICLE_GRAMMARS "/" + model))
    if (entry.path().extension() != ".json") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  REQUIRE_FALSE(text.str().empty());
  return text.str();
}

}  // namespace panicle::tests
