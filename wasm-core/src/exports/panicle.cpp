#include "exports/panicle.h"

#include <cstdlib>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "exports/host.hpp"
#include "exports/linked_models.hpp"
#include "foundation/container.hpp"
#include "plant/geometry_check.hpp"
#include "protocol/answer.hpp"
#include "protocol/messages.generated.hpp"
#include "protocol/request.hpp"

namespace {

using namespace panicle;

constexpr std::uint32_t max_request_bytes = 16 * 1024 * 1024;

// The linked model of that name; null if there is none.
const Model* find_model(std::string_view name) {
  for (const Model* model : linked_models())
    if (model->name == name) return model;
  return nullptr;
}

// The compiled texts of all calls, by handles that the caller holds.
CompiledTexts& compiled_texts() {
  static CompiledTexts texts;
  return texts;
}

// The cache of a model's last growth. Natively several models are linked: only the cache of the last requested one is
// stored.
CacheSlot& cache_of(const Model& model) {
  static const Model* owner = nullptr;
  static CacheSlot cache;
  if (owner != &model) cache.reset();
  owner = &model;
  return cache;
}

// The last plant, whose large arrays its response refers to. It is freed when the response is released or another plant
// is requested.
struct Answered {
  Plant plant;
  std::uint8_t* block = nullptr;
};
// The last plant and its response.
Answered& answered() {
  static Answered last;
  return last;
}

// Compiles a text for the linked model, and returns its handle. Errors: those of compiling; limit if too many texts are
// stored.
Result<std::uint32_t> compile(std::string_view text) {
  const Model& model = *linked_models().front();
  if (model.compile_text == nullptr) return bad_request(message(messages::protocol::model_compiles_no_texts));
  auto compiled = model.compile_text(text, Limits{});
  if (!compiled) return compiled.error();
  const std::uint32_t handle = compiled_texts().add(std::move(compiled.value()));
  if (handle == 0) return Diagnostic{Reason::limit, message(messages::protocol::too_many_compiled)};
  return handle;
}

// Removes repeated notes: several parts of a model may reach one limit.
void remove_repeated_notes(std::vector<std::string>& notes) {
  std::unordered_set<std::string> known;
  std::erase_if(notes, [&](const std::string& note) { return !known.insert(note).second; });
}

// Grows a plant from the bytes of a request: reads its blocks, finds the model that they name and runs it within a
// budget of work, memory and time. Errors: bad_request for bytes that are no container or an unknown model; those of
// the model; those of check_geometry.
Result<Plant> grow(std::span<const std::uint8_t> bytes) {
  const auto blocks = read_container(bytes);
  if (!blocks) return blocks.error();
  const Model* const model = find_model(Request(blocks.value(), nullptr).text("model"));
  if (model == nullptr) return bad_request(message(messages::protocol::model_unknown));
  Request request(blocks.value(), &compiled_texts(), &cache_of(*model));
  Limits limits;
  WorkBudget budget(limits.work, limits.bytes, panicle_time_passed);
  limits.budget = &budget;
  auto plant = model->grow(request, limits);
  if (!plant) return plant;
  remove_repeated_notes(plant->notes);
  if (Diagnostic error = check_geometry(plant.value()); error.reason != Reason::none) return error;
  return plant;
}

}  // namespace

extern "C" {

// The version of this interface.
std::uint32_t panicle_abi(void) { return 5; }

// Allocates memory for a request; null if it is too large.
void* panicle_allocate(std::uint32_t bytes) {
  return bytes <= max_request_bytes ? std::malloc(bytes ? bytes : 1) : nullptr;
}

// Frees memory of a request or a response; with the last response also its plant.
void panicle_release(void* memory) {
  if (memory != nullptr && memory == answered().block) answered() = {};
  std::free(memory);
}

// Grows a plant from a request, and returns its response, a container of columns.
std::uint8_t* panicle_grow(const std::uint8_t* request, std::uint32_t bytes) {
  answered() = {};
  auto plant = grow({request, bytes});
  if (!plant) return write_failure(plant.error());
  answered().plant = std::move(plant.value());
  return answered().block = write_plant(answered().plant);
}

// Compiles a text, and returns a response with its handle or an error.
std::uint8_t* panicle_compile(const char* text, std::uint32_t bytes) {
  const auto program = compile({text, bytes});
  return program ? write_program(program.value()) : write_failure(program.error());
}

// Frees a compiled text.
void panicle_forget(std::uint32_t program) { compiled_texts().remove(program); }

}  // extern "C"
