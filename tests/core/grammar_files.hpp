// Grammar files of the repository, for tests that read them.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace panicle::tests {

// The repository's root, an absolute path. Defined in main.cpp alone, so that a compiler cache can share all other
// objects between checkouts.
std::string repository_folder();

// The grammar files of a model, sorted by name.
inline std::vector<std::filesystem::path> grammar_files(const std::string& model) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(repository_folder() + "/wasm-core/grammars/" + model))
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
