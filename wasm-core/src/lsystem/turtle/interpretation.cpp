#include "lsystem/turtle/interpretation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "expression/code.hpp"
#include "lsystem/derivation/branch.hpp"
#include "lsystem/derivation/machine.hpp"
#include "lsystem/derivation/skippable_symbols.hpp"
#include "lsystem/derivation/string_text.hpp"
#include "lsystem/derivation/watcher.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/syntax/parser.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string; a lineage is the address of a module and the symbols of its
// ancestors; homomorphism rules replace modules while the string is drawn, without changing it.

namespace {

constexpr float max_colours = 255;
// The largest coordinate and the range of sizes that can be drawn, in the text's unit: the square of an area is finite
// up to `farthest`, and the square of a size below `least_size` would be 0.
constexpr float farthest = 1e9f, least_size = 1e-18f;

// Whether a coordinate is small enough to be drawn.
bool is_near(float value) { return std::fabs(value) <= farthest; }
bool is_near(const glm::vec3& p) { return is_near(p.x) && is_near(p.y) && is_near(p.z); }
// Whether a vector has about length 1.
bool is_unit(const glm::vec3& v) { return std::fabs(glm::dot(v, v) - 1) < 0.01f; }

// How query modules (?E, ?P, ?H, ?L, ?U) are handled.
enum class QueryMode : std::uint8_t {
  draw_response,   // the listener responds to ?E, and the matching production is drawn in place
  write_response,  // the listener responds to ?E, and the response is written into the string
  write_turtle,    // the turtle's position and axes are written into ?P, ?H, ?L and ?U; the listener gets no events
  skip,            // queries are neither sent nor drawn
};

// Interpreter of a string as commands of a turtle, a cursor with a position and three axes that draws as it moves.
// Events go to the listener. `module` points to the words of a module, `source` to those of the module of the string
// that it is drawn for.
class Interpreter {
 public:
  Interpreter(const BoundProgram& bound, const Turtle& start, Listener& listener, std::uint64_t seed,
              const Limits& limits, const Space* space, Watcher* watcher = nullptr)
      : machine_(bound, seed, limits, space),
        bound_(bound),
        program_(*bound.program),
        limits_(limits),
        listener_(listener),
        watcher_(watcher),
        turtle_(start),
        turns_(program_.notation == Notation::cpfg ? -1.0f : 1.0f) {
    if (program_.has(Purpose::homomorphism)) images_ = program_.rules_of(Purpose::homomorphism).data();
    if (const auto& width = bound.settings[static_cast<std::size_t>(GlobalSetting::line_width)]) turtle_.width = *width;
    const auto setting = [&](GlobalSetting which) { return bound.settings[static_cast<std::size_t>(which)]; };
    if (setting(GlobalSetting::tropism_x))
      turtle_.tropism = {*setting(GlobalSetting::tropism_x), *setting(GlobalSetting::tropism_y),
                         *setting(GlobalSetting::tropism_z)};
    turtle_.elasticity = setting(GlobalSetting::elasticity).value_or(turtle_.elasticity);
  }

  // Interprets a string. Returns the number of lines. `responded` is the string itself if responses are written into
  // it, else null.
  Result<std::uint32_t> run(const String& string, QueryMode query_mode, String* responded = nullptr) {
    query_mode_ = query_mode;
    responded_ = responded;
    if (query_mode == QueryMode::draw_response && program_.not_drawable.reason != Reason::none)
      return program_.not_drawable;
    const bool is_silent = query_mode == QueryMode::write_turtle;
    SkippableSymbols skippable(program_, images_, !is_silent);
    if (is_silent) skippable.find_branches(string);
    const std::uint32_t* at = string.begin();
    const std::uint32_t* const end = string.end();
    string_ = at;
    // The cost of a walk itself. Drawing the image of a module is counted where its successor is written.
    if (!machine_.spend(program_.symbols.size() / 16)) return machine_.error();
    for (; at < end; ++module_) {
      if (module_ % 64 == 0 && !machine_.spend(16)) return machine_.error();
      if (is_silent) at = skippable.behind_branches(string, at);
      const std::uint32_t* const module = at;
      if (at == end) break;
      const std::uint32_t symbol = symbol_of(*module);
      at += words_of(*module);
      if (skippable.covers(symbol)) continue;
      const bool cut = has_image(symbol) ? draw_module(module, module, 0) : execute(module, module);
      if (machine_.failed()) return machine_.error();
      if (!cut) continue;
      const RestOfBranch rest = rest_of_branch(at, end);
      at = rest.end;
      module_ += static_cast<std::uint32_t>(rest.modules);
    }
    if (!polygons_.empty()) note(message(messages::lsystem::polygon_never_closed), 1);
    return static_cast<std::uint32_t>(lines_);
  }

 private:
  // A polygon that is open: the turtle at its beginning, its thickness (0: a sheet) and corners so far.
  struct Polygon {
    Turtle start;
    float thickness;
    std::vector<glm::vec3> corners;
  };

  // Whether a homomorphism (a rule for drawing alone) replaces modules of a symbol.
  bool has_image(std::uint32_t symbol) const { return images_ != nullptr && images_[symbol].productions.size() > 0; }

  // Draws the homomorphism of a module in its place, recursively up to the depth of the text. Returns true if the rest
  // of the branch is cut.
  bool draw_module(const std::uint32_t* module, const std::uint32_t* source, std::uint32_t depth) {
    if (depth < bound_.depths[1]) {
      const Production* const production = machine_.choose(module, images_);
      if (machine_.failed()) return false;
      if (production != nullptr) return draw_image(production->successor, module, source, depth);
    }
    return program_.meanings[symbol_of(*module)] != no_meaning && execute(module, source);
  }

  // Draws the successor that a homomorphism gives a module in place of it. Returns true if the rest of the branch is
  // cut.
  bool draw_image(const Template& successor, const std::uint32_t* module, const std::uint32_t* source,
                  std::uint32_t depth) {
    if (!machine_.spend(1 + successor.modules / 2)) return false;
    if (image_words_.size() <= depth) image_words_.resize(depth + 1);
    const Origin origin = has_lineage(*module) ? origin_of(module) : Origin{};
    if (!image_words_[depth].reserve(successor.words, limits_.words)) return !no_memory();
    if (!machine_.write(successor, image_words_[depth].data(), origin, symbol_of(*module))) return false;
    const std::uint32_t* at = image_words_[depth].data();
    const std::uint32_t* const end = at + successor.words;
    while (at < end) {
      const std::uint32_t* const part = at;
      at += words_of(*part);
      const bool cut = draw_module(part, source, depth + 1);
      if (machine_.failed()) return false;
      if (!cut) continue;
      at = rest_of_branch(at, end).end;
      if (at == end) return true;
    }
    return false;
  }

  // Fails since there is no memory.
  bool no_memory() {
    return machine_.fail(error_at(Reason::limit, {}, message(messages::lsystem::no_memory_for_drawing)));
  }

  // The default of an omitted argument.
  float standard(const TurtleSymbol& symbol) const {
    if (symbol.setting == Setting::angle_increment) return setting(GlobalSetting::angle_increment, symbol.standard);
    if (symbol.setting == Setting::line_length) return setting(GlobalSetting::line_length, symbol.standard);
    return symbol.standard;
  }
  // The value of a global setting, or `otherwise`.
  float setting(GlobalSetting which, float otherwise) const {
    return bound_.settings[static_cast<std::size_t>(which)].value_or(otherwise);
  }

  // The three parameters of a module from the given one on; 0 for missing ones.
  glm::vec3 vector_of(const std::uint32_t* module, std::uint32_t first) const {
    glm::vec3 v(0);
    for (std::uint32_t i = 0; i < 3 && first + i < parameters_of(*module); ++i)
      std::memcpy(&v[static_cast<int>(i)], module + 1 + first + i, sizeof(float));
    return v;
  }

  // Executes one turtle command, with the lineage of the module `source`. Returns true if the rest of the branch is
  // cut.
  bool execute(const std::uint32_t* module, const std::uint32_t* source) {
    const std::uint32_t number = symbol_of(*module);
    const TurtleSymbol& symbol = turtle_symbols[program_.meanings[number]];
    const bool given = parameters_of(*module) > 0;
    float value = 0;
    if (given) {
      std::memcpy(&value, module + 1, sizeof value);
    } else {
      value = standard(symbol);
    }
    switch (symbol.action) {
      case Action::line:
        if (polygons_.empty()) {
          line(value, module, source);
        } else {
          move(value, module);
          corner();
        }
        break;
      case Action::move:
        move(value, module);
        if (!polygons_.empty()) corner();
        break;
      case Action::line_apart:
        line(value, module, source);
        break;
      case Action::move_apart:
        move(value, module);
        break;
      case Action::sphere:
        sphere(value, module, source);
        break;
      case Action::turn:
        turn(turtle_,
             symbol.action == Action::turn && symbol.max_arguments == 0 ? value : turns_ * symbol.sign * value);
        break;
      case Action::pitch:
        pitch(turtle_, turns_ * symbol.sign * value);
        break;
      case Action::roll:
        roll(turtle_, turns_ * symbol.sign * value);
        break;
      case Action::width:
        set_width(value, given, -1);
        break;
      case Action::widen:
        set_width(value, given, 1);
        break;
      case Action::push:
        push();
        break;
      case Action::pop:
        turtle_ = stack_.back();
        stack_.pop_back();
        break;
      case Action::cut:
        if (query_mode_ != QueryMode::write_turtle) listener_.cut(turtle_);
        return true;
      case Action::query:
        return query(module);
      default:
        execute_rare(symbol.action, module, source, value, given);
    }
    return false;
  }

  // Executes the turtle commands that are rare in texts.
  void execute_rare(Action action, const std::uint32_t* module, const std::uint32_t* source, float value, bool given) {
    switch (action) {
      case Action::level:
        level(turtle_);
        break;
      case Action::go_to:
        turtle_.position = vector_of(module, 0);
        check_place(module);
        break;
      case Action::head_for:
        head_for(turtle_, vector_of(module, 0), vector_of(module, 3));
        break;
      case Action::elasticity:
        if (const glm::vec3 arguments = vector_of(module, 0); arguments[0] == 0) turtle_.elasticity = arguments[1];
        break;
      case Action::size:
        turtle_.size = value;
        break;
      case Action::enlarge:
        enlarge(turtle_.size * value, value, module);
        break;
      case Action::reduce:
        if (value > 0) enlarge(turtle_.size / value, value, module);
        break;
      case Action::next_colour:
        set_colour(given ? value : static_cast<float>(turtle_.colour + 1));
        break;
      case Action::last_colour:
        set_colour(given ? value : static_cast<float>(turtle_.colour - 1));
        break;
      case Action::begin_polygon:
        begin_polygon(value, module);
        break;
      case Action::corner:
        if (!polygons_.empty())
          corner();
        else
          note(message(messages::lsystem::corner_outside_polygon), 2);
        break;
      case Action::end_polygon:
        end_polygon(source);
        break;
      case Action::surface:
      case Action::ball:
      case Action::disc:
      case Action::circle:
        if (query_mode_ != QueryMode::write_turtle && value != 0 && turtle_.size != 0 &&
            can_draw(value * turtle_.size, module))
          draw_whole(action, module, source, value * turtle_.size);
        break;
      case Action::query_position:
      case Action::query_heading:
      case Action::query_left:
      case Action::query_up:
        if (query_mode_ == QueryMode::write_turtle) locate(action, module);
        break;
      default:
        break;
    }
  }

  // Reports a shape at the turtle to the listener: a surface, ball, disc or circle.
  void draw_whole(Action action, const std::uint32_t* module, const std::uint32_t* source, float size) {
    if (action == Action::surface)
      listener_.surface(turtle_, std::string_view(program_.symbols[symbol_of(*module)]).substr(1), size,
                        lineage_of(source));
    if (action == Action::ball) listener_.ball(turtle_, size / 2, lineage_of(source));
    if (action == Action::disc) listener_.disc(turtle_, size / 2, lineage_of(source));
    if (action != Action::circle) return;
    Turtle upright = turtle_;
    pitch(upright, 90);
    listener_.disc(upright, size / 2, lineage_of(source));
  }

  // Sets the line width. Without an argument `!` narrows and `#` widens it by the increment; in the paper's notation !
  // alone is 1.
  void set_width(float value, bool given, float sign) {
    if (!given && program_.notation == Notation::cpfg) {
      const float by = setting(GlobalSetting::line_width_increment, 0);
      turtle_.width = std::max(0.0f, turtle_.width + sign * by);
    } else if (given || sign < 0) {
      turtle_.width = value;
    }
  }

  // Sets the colour's index, from 1 on.
  void set_colour(float value) { turtle_.colour = static_cast<std::int32_t>(std::clamp(value, 1.0f, max_colours)); }

  // Opens a polygon.
  void begin_polygon(float thickness, const std::uint32_t* module) {
    if (!is_near(thickness * turtle_.size)) return refuse(module, message(messages::lsystem::polygon_too_thick));
    if (polygons_.size() < limits_.depth) {
      polygons_.push_back({turtle_, thickness * turtle_.size, {}});
      return;
    }
    machine_.fail(error_at(Reason::limit, {}, message(messages::lsystem::too_many_polygons, limits_.depth)));
  }

  // Adds the turtle's position to the open polygon.
  void corner() {
    if (machine_.spend(1)) polygons_.back().corners.push_back(turtle_.position);
  }

  // Closes the last polygon and reports it.
  void end_polygon(const std::uint32_t* source) {
    if (polygons_.empty()) return note(message(messages::lsystem::polygon_never_opened), 4);
    if (query_mode_ != QueryMode::write_turtle) {
      const Polygon& closed = polygons_.back();
      if (closed.thickness > 0)
        listener_.plate(closed.start, closed.corners, closed.thickness, lineage_of(source));
      else
        listener_.polygon(closed.start, closed.corners, lineage_of(source));
    }
    polygons_.pop_back();
  }

  // Reports each kind of note once.
  void note(const Message& problem, std::uint32_t kind) {
    if ((noted_ & kind) == 0 && query_mode_ != QueryMode::write_turtle) listener_.note(problem.encoded());
    noted_ |= kind;
  }

  // Writes the turtle's position or one of its axes into the parameters of a query.
  void locate(Action action, const std::uint32_t* module) {
    if (responded_ == nullptr || module < responded_->begin() || module >= responded_->end()) return;
    const glm::vec3& at = action == Action::query_position  ? turtle_.position
                          : action == Action::query_heading ? turtle_.heading
                          : action == Action::query_left    ? turtle_.left
                                                            : turtle_.up;
    const std::uint32_t count = std::min<std::uint32_t>(3, parameters_of(*module));
    std::uint32_t* const written = responded_->words.data() + (module - responded_->begin());
    for (std::uint32_t i = 0; i < count; ++i) set_parameter(written, i, at[static_cast<int>(i)]);
  }

  // The lineage of a module: its parent, grandparent and address.
  Lineage lineage_of(const std::uint32_t* module) const {
    if (!has_lineage(*module)) return {{}, {}, 0, no_symbol, no_symbol, module_};
    const Origin origin = origin_of(module);
    const std::uint32_t parent = origin.ancestors & 0xffff, grandparent = origin.ancestors >> 16;
    return {name_of(parent), name_of(grandparent), origin.address, parent, grandparent, module_};
  }

  // The name of a symbol; empty for none.
  std::string_view name_of(std::uint32_t symbol) const {
    return symbol == no_symbol ? std::string_view() : std::string_view(program_.symbols[symbol]);
  }

  // Fails with a problem at a module.
  void refuse(const std::uint32_t* module, const Message& problem) {
    machine_.fail(error_at(Reason::evaluation, {},
                           message(messages::lsystem::at_module, module_ + 1, module_text(program_, module), problem)));
  }

  // Fails if the turtle is too far away.
  void check_place(const std::uint32_t* module) {
    if (!is_near(turtle_.position)) refuse(module, message(messages::lsystem::too_far));
  }

  // Moves the turtle ahead by `distance` drawing sizes. `module` is for error messages.
  void move(float distance, const std::uint32_t* module) {
    turtle_.position = ahead(turtle_, distance * turtle_.size);
    check_place(module);
  }

  // Sets the drawing size to `size`, which is the old one times or over `by`; fails if it has become too small for a
  // float. `module` is for error messages.
  void enlarge(float size, float by, const std::uint32_t* module) {
    if (size == 0 && by != 0 && turtle_.size != 0) return refuse(module, message(messages::lsystem::size_underflow));
    turtle_.size = size;
  }

  // Whether something of this size can be drawn at the turtle; if not, the interpretation fails.
  bool can_draw(float size, const std::uint32_t* module) {
    if (!is_near(size))
      refuse(module, message(messages::lsystem::too_large));
    else if (std::fabs(size) < least_size)
      refuse(module, message(messages::lsystem::too_small));
    else if (!is_near(turtle_.width))
      refuse(module, message(messages::lsystem::too_wide));
    else if (!is_unit(turtle_.heading) || !is_unit(turtle_.left))
      refuse(module, message(messages::lsystem::no_direction));
    return !machine_.failed();
  }

  // Moves the turtle ahead and draws a line.
  void line(float distance, const std::uint32_t* module, const std::uint32_t* source) {
    if (distance == 0 || turtle_.size == 0) return;
    if (!can_draw(distance * turtle_.size, module)) return;
    const Turtle before = turtle_;
    move(distance, module);
    if (machine_.failed()) return;
    turtle_.line = lines_++;
    if (query_mode_ != QueryMode::write_turtle) listener_.line(turtle_.line, before, turtle_, lineage_of(source));
    if (turtle_.elasticity != 0) bend(turtle_);
  }

  // Moves the turtle ahead by a radius and draws a sphere.
  void sphere(float radius, const std::uint32_t* module, const std::uint32_t* source) {
    if (radius == 0 || turtle_.size == 0 || !can_draw(radius * turtle_.size, module)) return;
    move(radius, module);
    if (!machine_.failed() && query_mode_ != QueryMode::write_turtle)
      listener_.sphere(turtle_, radius * turtle_.size, lineage_of(source));
  }

  // Saves the turtle's state at the beginning of a branch.
  void push() {
    if (stack_.size() < limits_.depth) {
      stack_.push_back(turtle_);
      return;
    }
    machine_.fail(error_at(Reason::limit, {}, message(messages::lsystem::too_many_branches, limits_.depth)));
  }

  // Sends a query to the listener and draws or writes its response. Returns true if the response cut the branch.
  bool query(const std::uint32_t* module) {
    if (query_mode_ == QueryMode::skip || query_mode_ == QueryMode::write_turtle) return false;
    const std::uint32_t count = parameters_of(*module);
    float parameters[max_parameters];
    std::memcpy(parameters, module + 1, count * sizeof(float));
    float before[max_parameters];
    std::copy_n(parameters, count, before);
    listener_.query(turtle_, {parameters, count}, lineage_of(module));
    if (!machine_.spend(1)) return false;        // also where the response has used up the work
    const auto write = [&](std::uint32_t* to) {  // changed parameters only: the others keep their double precision
      for (std::uint32_t i = 0; i < count; ++i)
        if (std::memcmp(&parameters[i], &before[i], sizeof(float)) != 0) set_parameter(to, i, parameters[i]);
    };
    if (query_mode_ == QueryMode::draw_response) {
      std::uint32_t responded[1 + max_parameters + lineage_words + 2 * max_parameters + block] = {};
      std::memcpy(responded, module, words_of(*module) * sizeof *module);
      write(responded);
      return draw_response(module, responded);
    }
    if (module >= responded_->begin() && module < responded_->end())
      write(responded_->words.data() + (module - responded_->begin()));
    return false;
  }

  // Applies the production that matches the response and draws its successor in place. `responded`: a copy of the
  // module with the response in its parameters, followed by a block of unused words.
  bool draw_response(const std::uint32_t* module, const std::uint32_t* responded) {
    const Production* const production = machine_.choose(responded);
    if (production == nullptr) return false;
    const Template& successor = production->successor;
    if (!response_.reserve(successor.words, successor.words))
      return !machine_.fail(error_at(Reason::limit, {}, message(messages::lsystem::no_memory_for_response)));
    if (!machine_.write(successor, response_.data(), {}, query_symbol)) return false;
    if (watcher_ != nullptr) {
      watcher_->rewrites(static_cast<std::uint64_t>(module - string_));
      watcher_->applied(*production, machine_);
    }
    return draw_all(response_.data(), response_.data() + successor.words, module);
  }

  // Executes a range of modules. Returns true if the rest of the branch is cut.
  bool draw_all(const std::uint32_t* at, const std::uint32_t* end, const std::uint32_t* source) {
    while (at < end) {
      const std::uint32_t* const module = at;
      at += words_of(*module);
      const bool cut = symbol_of(*module) != query_symbol && execute(module, source);
      if (machine_.failed()) return false;
      if (!cut) continue;
      at = rest_of_branch(at, end).end;
      if (at == end) return true;
    }
    return false;
  }

  Machine machine_;
  const BoundProgram& bound_;
  const Program& program_;
  const Limits& limits_;
  Listener& listener_;
  Watcher* watcher_;
  const std::uint32_t* string_ = nullptr;
  Turtle turtle_;
  const float turns_;  // which way the notation turns
  const Rules* images_ = nullptr;
  std::vector<Words> image_words_;  // by depth
  std::vector<Turtle> stack_;
  std::vector<Polygon> polygons_;  // that are open
  Words response_;
  QueryMode query_mode_ = QueryMode::draw_response;
  String* responded_ = nullptr;
  std::int32_t lines_ = 0;
  std::uint32_t module_ = 0;
  std::uint32_t noted_ = 0;
};

// Ignores all events.
class NullListener : public Listener {
  void line(std::int32_t, const Turtle&, const Turtle&, const Lineage&) override {}
  void sphere(const Turtle&, float, const Lineage&) override {}
  void query(const Turtle&, std::span<float>, const Lineage&) override {}
  void cut(const Turtle&) override {}
};

// Interprets a string and writes responses into it. Returns the error, if any.
Diagnostic write_into(const BoundProgram& bound, String& string, const Turtle& start, Listener& listener,
                      std::uint64_t seed, const Limits& limits, const Space* space, QueryMode query_mode) {
  const auto walked = Interpreter(bound, start, listener, seed, limits, space).run(string, query_mode, &string);
  return walked ? Diagnostic{} : walked.error();
}

}  // namespace

Result<std::uint32_t> interpret(const BoundProgram& bound, const String& string, const Turtle& start,
                                Listener& listener, std::uint64_t seed, const Limits& limits, const Space* space,
                                Watcher* watcher) {
  return Interpreter(bound, start, listener, seed, limits, space, watcher).run(string, QueryMode::draw_response);
}

Result<std::uint32_t> interpret_without_queries(const BoundProgram& bound, const String& string, const Turtle& start,
                                                Listener& listener, std::uint64_t seed, const Limits& limits,
                                                const Space* space) {
  return Interpreter(bound, start, listener, seed, limits, space).run(string, QueryMode::skip);
}

Diagnostic write_responses(const BoundProgram& bound, String& string, const Turtle& start, Listener& listener,
                           std::uint64_t seed, const Limits& limits, const Space* space) {
  return write_into(bound, string, start, listener, seed, limits, space, QueryMode::write_response);
}

Diagnostic locate(const BoundProgram& bound, String& string, const Turtle& start, std::uint64_t seed,
                  const Limits& limits, const Space* space) {
  NullListener is_silent;
  return write_into(bound, string, start, is_silent, seed, limits, space, QueryMode::write_turtle);
}

}  // namespace panicle::lsystem
