#include "lsystem_plant/requested_program.hpp"

namespace panicle {

Result<CompiledText> compile_program(std::string_view text, const ProgramOptions& options, const Limits& limits) {
  auto program = lsystem::compile(text, limits, options.lineages, options.notation);
  if (!program) return program.error();
  return CompiledText(std::move(program.value()));
}

std::shared_ptr<const lsystem::Program> program_by_handle(Request& request) {
  return std::static_pointer_cast<const lsystem::Program>(request.compiled_text());
}

Result<std::shared_ptr<const lsystem::Program>> requested_program(Request& request, const ProgramOptions& options,
                                                                  const Limits& limits) {
  auto program = program_by_handle(request);
  const std::string_view grammar = request.text("grammar");
  if (program) return program;
  if (const Diagnostic trouble = request.first_trouble(); trouble.reason != Reason::none) return trouble;
  if (grammar.empty()) return Diagnostic{Reason::bad_request, "The request has no grammar.", 0, 0};
  return lsystem::compile(grammar, limits, options.lineages, options.notation);
}

}  // namespace panicle
