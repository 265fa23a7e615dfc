// Reads a flower's text into a program, statement by statement.
#pragma once

#include <bitset>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "expression/statement_reader.hpp"
#include "models/flower/syntax/program.hpp"

namespace panicle::flower {

// The form of a list of numbers: the thesis's text has eight, its tables nine with the translation.
enum class Form : std::uint8_t { plain, translated };

inline constexpr std::size_t most_variables = 1000;

class FlowerReader : expression::StatementReader {
 public:
  FlowerReader(std::span<const expression::Token> tokens, Program& program, expression::Lowering& lowering);

  // False: `trouble()`.
  bool run();
  using StatementReader::trouble;

 private:
  struct Statement {
    std::size_t begin, end;
    std::uint32_t grammar;
  };
  // The parts of a plant that an expression depends on: no larger where a text repeats them.
  struct Uses {
    std::bitset<most_variables> variables;
    bool age = false, values = false, locals = false, draws = false;
    void add(const Uses& other);
  };
  // Where an expression is, which limits the names that it may use.
  enum class Scope : std::uint8_t { variable, description, production };
  struct Blocks {
    std::size_t before = 0, condition = 0, after = 0;  // first tokens within, 0 where there are none
    std::size_t before_end = 0, condition_end = 0, after_end = 0;
  };

  // First pass: statements, names of modules, volumes and variables.
  bool split_statements();
  bool begin_module(std::size_t end);
  bool declare(const Statement& statement);
  void find_forms_of_modules();
  bool declare_volume(const Statement& statement);
  bool declare_variable(const Statement& statement);

  // Second pass.
  bool statement(const Statement& statement);
  bool definition();
  bool volume();
  bool variable();
  bool axiom();
  bool material();
  bool material_settings(Material& material);
  bool colour(std::uint32_t& colour);
  bool colours(Colours& colours);
  bool veins_of(Material& material);
  bool part_name(std::string& name);
  bool share(float& value, float most);
  bool production();
  bool blocks(Blocks& blocks);
  bool block(std::size_t& begin, std::size_t& end);
  // Reads `name = expression;` any number of times: `read(name, end)` reads an expression, which ends at `end`.
  template <class Read>
  bool each_assignment(std::size_t begin, std::size_t end, const Message& advice, Read read);
  bool assignments(std::size_t begin, std::size_t end);
  bool condition_of(const Blocks& blocks, Production& production);
  bool both_blocks(const Blocks& blocks, const Production& production);
  bool grow(const Blocks& blocks, Production& production);
  bool growth(const Blocks& blocks, Production& production);
  bool is_unclosed(bool module);
  bool settings(GrowAction& growth);
  bool setting(GrowAction& growth, const expression::Token& name, std::size_t value_end);
  bool too_much(const expression::SourceLocation& place);
  bool faces(GrowAction& growth);
  bool face(FaceOf& face);
  bool glue(Production& production);
  bool split(const Blocks& blocks, Production& production);
  bool label_with_face(std::uint32_t& label, Face& face);
  bool label_named(std::uint32_t& label);

  // Reads `( , , 2, )`, where there is one: given values, each in its field.
  bool description(Form form, Scope scope, Description& description);
  // The comma or the ) that ends the current entry; the statement's end for none.
  std::size_t entry_end() const;
  // Compiles an expression. `used`: its dependences.
  bool number(std::size_t end, Scope scope, bool of_map, Number& number, Uses* used = nullptr);
  bool knows_functions(std::size_t end);
  bool rewritten(expression::Expression& tree, Scope scope, Uses& uses, bool& draws);
  bool unknown(const expression::Node& node, Scope scope);
  void mark_rebuilding(const Uses& uses);
  // Marks figures that the map depends on.
  void pin_numbers(std::size_t begin, std::size_t end);
  void append_structure_key();
  std::uint32_t find_label(std::string_view name) const;
  std::uint32_t find_variable(std::string_view name, std::uint32_t grammar) const;
  std::uint32_t find_grammar(std::string_view name) const;
  std::string key_of(std::string_view name, std::uint32_t grammar) const;
  std::uint64_t next_key() { return ++keys_; }
  void note_unreached();
  void finish();

  Program& program_;
  std::vector<expression::Named> formals_;
  std::vector<Statement> statements_;
  std::vector<Form> forms_;             // of labels
  std::vector<Form> forms_of_modules_;  // of each module's first volume
  std::vector<std::string_view> keys_of_variables_;
  std::vector<Uses> uses_of_variables_;  // of variables' definitions and of the calls that give them
  std::bitset<most_variables> rebuilding_;
  enum class Figure : std::uint8_t { unread, free, pinned };
  std::vector<Figure> figures_;                             // of tokens that are numbers
  std::vector<std::pair<std::uint32_t, Statement>> calls_;  // calls that give variables their values
  std::vector<Statement> definitions_;                      // of variables
  Statement read_{0, 0, 0};                                 // the current statement
  expression::Names labels_, variables_, grammars_;         // by key_of; modules by name
  std::deque<std::string> spelled_;
  std::vector<std::string_view> locals_;
  Uses of_blocks_;  // dependences of the names that a production's blocks set
  struct Renamed {
    std::uint32_t line, from, to;
  };
  std::vector<Renamed> renamed_;
  std::uint32_t grammar_ = 0;  // the current grammar
  std::uint32_t known_variables_ = 0;
  std::uint64_t keys_ = 0;
  std::uint64_t production_key_ = 0;
  // Numbers of tokens of blocks: of this production, and of all compiled copies.
  std::uint64_t read_here_ = 0, read_again_ = 0;
};

}  // namespace panicle::flower
