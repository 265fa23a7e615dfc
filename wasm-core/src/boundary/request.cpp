#include "boundary/request.hpp"

#include <cstring>

#include "foundation/bits.hpp"

namespace panicle::boundary {
namespace {

constexpr std::uint32_t magic = 0x4c434e50;  // "PNCL"
constexpr std::uint32_t layout = 2;
constexpr std::uint32_t model_bunch = 1;
constexpr std::uint32_t output_meshes = 1, output_measures = 2;
constexpr std::size_t header_words = 12;
constexpr std::uint32_t most_numbers = 100'000;  // parameters, values of n, thinned berries

enum Word {
  w_magic,
  w_layout,
  w_model,
  w_outputs,
  w_seed,
  w_sides,
  w_segments,
  w_parameters,
  w_m,
  w_n,
  w_grammar,
  w_thinned
};

Diagnostic refused(const char* why) { return {Reason::bad_request, why, 0, 0}; }

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t index) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + index * 4, 4);
  return value;
}

}  // namespace

Result<bunch::Request> read_request(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < header_words * 4) return refused("The request is shorter than its header.");
  if (word(bytes, w_magic) != magic) return refused("The request does not begin with its magic word.");
  if (word(bytes, w_layout) != layout) return refused("The request's layout is of another version; reload the page.");
  if (word(bytes, w_model) != model_bunch) return refused("The request asks for a model that is not known.");
  const std::uint32_t parameters = word(bytes, w_parameters), n = word(bytes, w_n), grammar = word(bytes, w_grammar);
  const std::uint32_t thinned = word(bytes, w_thinned);
  if (parameters > most_numbers || n > most_numbers || thinned > most_numbers)
    return refused("The request has more numbers than are allowed.");
  const std::uint64_t whole =
      (header_words + parameters + std::uint64_t{n} + thinned + (std::uint64_t{grammar} + 3) / 4) * 4;
  if (bytes.size() != whole) return refused("The request's length is not what its header says.");

  bunch::Request request;
  request.seed = word(bytes, w_seed);
  request.meshes = (word(bytes, w_outputs) & output_meshes) != 0;
  request.measures = (word(bytes, w_outputs) & output_measures) != 0;
  request.stem_sides = word(bytes, w_sides);
  request.berry_segments = word(bytes, w_segments);
  request.m = static_cast<std::int32_t>(word(bytes, w_m));
  for (std::size_t i = 0; i < parameters; ++i)
    request.parameters.push_back(bit_cast<float>(word(bytes, header_words + i)));
  for (std::size_t i = 0; i < n; ++i)
    request.n.push_back(static_cast<std::int32_t>(word(bytes, header_words + parameters + i)));
  for (std::size_t i = 0; i < thinned; ++i) request.thinned.push_back(word(bytes, header_words + parameters + n + i));
  const std::size_t text = (header_words + parameters + n + thinned) * 4;
  request.grammar = {reinterpret_cast<const char*>(bytes.data()) + text, grammar};
  return request;
}

}  // namespace panicle::boundary
