// The published grammars, and counts of modules in their strings.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "grammar_files.hpp"
#include "lsystem/derivation/words.hpp"
#include "lsystem/grammars.hpp"

namespace panicle::tests {

inline std::string file_text(const std::string& path) {
  std::ifstream file(path);
  INFO(path);
  REQUIRE(file.good());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string published(const std::string& name) {
  return file_text(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar/" + name + ".lsys");
}

inline std::vector<std::string> published_names() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar"))
    if (entry.path().extension() == ".lsys") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

// As the model compiles them that grows any text.
inline BoundPointer compiled_published(std::string_view text, const Inputs& inputs = {}) {
  using namespace lsystem;
  const Limits limits;
  return sound(bind(sound(compile(text, limits, Lineages::where_needed, Notation::cpfg)), inputs, limits));
}

// Where the model's turtle begins: upwards.
inline const Turtle upright{.heading = {0, 1, 0}, .left = {-1, 0, 0}, .up = {0, 0, 1}};

// Calls back with each module's symbol and parameters.
template <class Each>
void modules_of(const lsystem::String& string, const Each& each) {
  for (const std::uint32_t* at = string.begin(); at < string.end(); at += lsystem::words_of(*at)) {
    float parameters[32];
    const std::uint32_t count = lsystem::parameters_of(*at);
    std::memcpy(parameters, at + 1, count * sizeof(float));
    each(lsystem::symbol_of(*at), std::span<const float>(parameters, count));
  }
}

inline std::string_view name_of(const BoundProgram& bound, std::uint32_t symbol) {
  return lsystem::symbols(lsystem::program_of(bound))[symbol];
}

inline std::uint64_t count_of(const BoundProgram& bound, const lsystem::String& string, std::string_view symbol) {
  std::uint64_t count = 0;
  modules_of(string, [&](std::uint32_t s, std::span<const float>) { count += name_of(bound, s) == symbol; });
  return count;
}

// The first parameters of all modules of a symbol.
inline std::vector<float> parameters_of(const BoundProgram& bound, const lsystem::String& string,
                                        std::string_view symbol) {
  std::vector<float> found;
  modules_of(string, [&](std::uint32_t s, std::span<const float> parameters) {
    if (name_of(bound, s) == symbol) found.push_back(parameters[0]);
  });
  return found;
}

// As tests/golden/oracle.test.ts works them out.
inline std::uint32_t symbols_hash(const BoundProgram& bound, const lsystem::String& string) {
  std::uint32_t value = 0x811c9dc5;
  modules_of(string, [&](std::uint32_t symbol, std::span<const float>) {
    for (const char c : std::string(name_of(bound, symbol)) + " ")
      value = (value ^ static_cast<unsigned char>(c)) * 0x01000193u;
  });
  return value;
}

inline double parameters_sum(const lsystem::String& string) {
  double sum = 0;
  std::uint32_t i = 0;
  modules_of(string, [&](std::uint32_t, std::span<const float> parameters) {
    for (const float parameter : parameters) sum += std::abs(static_cast<double>(parameter)) * (1 + i++ % 7);
  });
  return sum;
}

}  // namespace panicle::tests
