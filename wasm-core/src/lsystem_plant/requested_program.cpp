#include "lsystem_plant/requested_program.hpp"

#include "lsystem_plant/messages.generated.hpp"

namespace panicle {

// Compiles the text of an L-system for later requests.
Result<CompiledText> compile_program(std::string_view text, const ProgramOptions& options, const Limits& limits) {
  auto program = lsystem::compile(text, limits, options.lineages, options.notation);
  if (!program) return program.error();
  return CompiledText(std::move(program.value()));
}

// The compiled L-system that a request names by its handle; null without a handle.
std::shared_ptr<const lsystem::Program> program_by_handle(Request& request) {
  return std::static_pointer_cast<const lsystem::Program>(request.compiled_text());
}

// The compiled L-system of a request: by its handle, or from its text.
Result<std::shared_ptr<const lsystem::Program>> requested_program(Request& request, const ProgramOptions& options,
                                                                  const Limits& limits) {
  auto program = program_by_handle(request);
  const std::string_view grammar = request.text("grammar");
  if (program) return program;
  if (const Diagnostic trouble = request.first_trouble(); trouble.reason != Reason::none) return trouble;
  if (grammar.empty()) return bad_request(message(messages::lsystem_plant::no_grammar));
  return lsystem::compile(grammar, limits, options.lineages, options.notation);
}

}  // namespace panicle
