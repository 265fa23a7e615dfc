// Productions that see their neighbours: examples of The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer
// 1990), and an oracle that goes through trees.
#include <algorithm>
#include <memory>

#include "foundation/random.hpp"
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::string in_context(const std::string& axiom, const std::string& production) {
  return after("axiom: " + axiom + "\n" + production, 1);
}

std::string error_of(std::string_view text) {
  std::string message;
  const std::string where = trouble(text, {}, {}, &message);
  return where + " " + message;
}

bool contains(const std::string& error, const char* part) { return error.find(part) != std::string::npos; }

// An axis as a tree: letters, and branches between them.
struct Axis {
  struct Item {
    char letter;
    std::unique_ptr<Axis> branch;
  };
  std::vector<Item> items;
};

Axis read_axis(const std::string& text, std::size_t& at) {
  Axis axis;
  while (at < text.size() && text[at] != ']') {
    if (text[at] == '[') {
      Axis inner = read_axis(text, ++at);
      axis.items.push_back({'[', std::make_unique<Axis>(std::move(inner))});
    } else if (text[at] != ' ') {
      axis.items.push_back({text[at], nullptr});
    }
    ++at;
  }
  return axis;
}

Axis read_axis(const std::string& text) {
  std::size_t at = 0;
  return read_axis(text, at);
}

struct Rule {
  std::string left, right;
  char letter, becomes;
};

class Oracle {
 public:
  Oracle(std::vector<Rule> rules, std::string passed_over)
      : rules_(std::move(rules)), passed_(std::move(passed_over)) {}

  std::string step(const Axis& axis) {
    written_.clear();
    std::string path;
    write(axis, path);
    return written_;
  }

 private:
  bool seen(char letter) const { return passed_.find(letter) == std::string::npos; }

  void write(const Axis& axis, std::string path) {
    for (std::size_t i = 0; i < axis.items.size(); ++i) {
      const Axis::Item& item = axis.items[i];
      if (item.branch) {
        written_ += '[';
        write(*item.branch, path);
        written_ += ']';
        continue;
      }
      written_ += rewritten(axis, i, path);
      if (seen(item.letter)) path += item.letter;
    }
  }

  char rewritten(const Axis& axis, std::size_t at, const std::string& path) const {
    for (const Rule& rule : rules_) {
      const bool left = path.size() >= rule.left.size() &&
                        path.compare(path.size() - rule.left.size(), std::string::npos, rule.left) == 0;
      if (rule.letter == axis.items[at].letter && left && goes_on(read_axis(rule.right), 0, axis, at + 1))
        return rule.becomes;
    }
    return axis.items[at].letter;
  }

  bool goes_on(const Axis& wanted, std::size_t i, const Axis& axis, std::size_t at) const {
    if (i == wanted.items.size()) return true;
    for (; at < axis.items.size(); ++at) {
      const Axis::Item &one = wanted.items[i], &there = axis.items[at];
      if (there.branch && !one.branch) continue;
      if (there.branch) {
        if (goes_on(*one.branch, 0, *there.branch, 0)) return goes_on(wanted, i + 1, axis, at + 1);
      } else if (seen(there.letter)) {
        return !one.branch && there.letter == one.letter && goes_on(wanted, i + 1, axis, at + 1);
      }
    }
    return false;
  }

  std::vector<Rule> rules_;
  std::string passed_;
  std::string written_;
};

std::string without_spaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::string spaced(const std::string& letters) {
  std::string text;
  for (const char letter : letters) (text += letter) += ' ';
  return text;
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  std::size_t below(std::size_t most) {
    return std::min(most - 1, static_cast<std::size_t>(random_unit(seed_, 1, count_++) * static_cast<double>(most)));
  }
  std::string letters(std::size_t most) {
    std::string text;
    for (std::size_t i = below(most + 1); i > 0; --i) text += "abcd"[below(4)];
    return text;
  }
  std::string tree(std::size_t most) {
    std::string text;
    std::size_t open = 0;
    for (std::size_t i = below(most + 1); i > 0; --i) {
      const std::size_t what = below(8);
      if (what == 0) {
        text += '[';
        ++open;
      } else if (what == 1 && open > 0) {
        text += ']';
        --open;
      } else {
        text += "abcd"[below(4)];
      }
    }
    return text + std::string(open, ']');
  }

 private:
  std::uint64_t seed_, count_ = 0;
};

}  // namespace

TEST_CASE("a signal goes along a row of cells, a cell a step (section 1.8)") {
  const char* text = "axiom: b a a a a a a a a\nb < a --> b\nb --> a";
  CHECK(after(text, 0) == "b a a a a a a a a");
  CHECK(after(text, 1) == "a b a a a a a a a");
  CHECK(after(text, 3) == "a a a b a a a a a");
  const char* back = "axiom: a a a b\na > b --> b\nb --> a";
  CHECK(after(back, 2) == "a b a a");
}

TEST_CASE(
    "in a tree the left context is the way from the root, the right one what goes on and branches (section 1.8)") {
  const char* axiom = "A B C [D E] [S G [H I [J K] L] M N O]";
  const auto rewritten = [&](const char* predecessor) {
    return in_context(axiom, std::string(predecessor) + " --> X").find('X') != std::string::npos;
  };
  CHECK(rewritten("B C < S > G [H] M"));
  CHECK(rewritten("A B C < S"));
  CHECK(rewritten("S > G M N O"));
  CHECK(rewritten("S > G [H I L] M"));
  CHECK(rewritten("H > I [J] L"));
  CHECK(rewritten("C < D > E"));
  CHECK(rewritten("C > [S] "));
  CHECK(rewritten("C > [D] [S]"));
  CHECK_FALSE(rewritten("E < S"));
  CHECK_FALSE(rewritten("A C < S"));
  CHECK_FALSE(rewritten("Z A B C < S"));
  CHECK_FALSE(rewritten("S > G H"));
  CHECK_FALSE(rewritten("S > G [I] M"));
  CHECK_FALSE(rewritten("S > G M [N]"));
  CHECK_FALSE(rewritten("E > S"));
  CHECK_FALSE(rewritten("C > [S] [D]"));
  CHECK_FALSE(rewritten("O > A"));
}

TEST_CASE("neighbours' parameters are read (equation 1.4), and decide") {
  const std::string text = "A(x) < B(y) > C(z) : x+y+z>10 --> E((x+y)/2) F((y+z)/2)\nA(x) < B(y) : x>y --> G(x-y)";
  CHECK(in_context("A(4) B(5) C(6)", text) == "A(4)E(4.5)F(5.5)C(6)");
  CHECK(in_context("A(1) B(2) C(6)", text) == "A(1)B(2)C(6)");
  CHECK(in_context("A(3) B(2) C(5)", text) == "A(3)G(1)C(5)");
  CHECK(in_context("A(3) B(2) C", text) == "A(3)G(1)C");
  CHECK(in_context("A(9,9) B(2) C(5)", text) == "A(9,9)B(2)C(5)");
  // Registers are loaded four at a time; the registers behind must not change.
  CHECK(in_context("A(1,2) B(3,4,5,6,7) C(8,9)", "A(a,b) < B(c,d,e,f,g) > C(h,i) --> R(a,b,c,d,e,f,g,h,i)") ==
        "A(1,2)R(1,2,3,4,5,6,7,8,9)C(8,9)");
}

TEST_CASE("contexts skip the symbols of ignore:, and match only those of consider:") {
  CHECK(in_context("b + F(2) - a", "ignore: + - F\nb < a --> c") == "b+F(2)-c");
  CHECK(in_context("b + F(2) - a", "b < a --> c") == "b+F(2)-a");
  CHECK(in_context("b + F(2) - a", "consider: a b\nb < a --> c") == "b+F(2)-c");
  CHECK(in_context("b + F(2) - a", "F(x) - < a --> c(x)") == "b+F(2)-c(2)");
  CHECK(in_context("a x [ x b ] x c", "ignore: x\na > [b] c --> d") == "d x[x b]x c");
  CHECK(after("axiom: ignore consider\nignore --> A\nconsider > ignore --> B", 1) == "A consider");
}

TEST_CASE("all modules match the string as it was before the step, including modules that a cut removes") {
  CHECK(in_context("a b", "a > b --> b\na < b --> a") == "b a");
  CHECK(in_context("a [ % b ] c", "a > [% b] c --> d") == "d[]c");
}

TEST_CASE("figure 1.31 a grows as worked out by hand from its productions") {
  // After Hogeweg and Hesper 1974; 0 and 1 are o and i here. A module at an end has a neighbour on one side alone.
  const char* text =
      "ignore: + - F\n"
      "axiom: F i F i F i\n"
      "o < o > o --> o\no < o > i --> i [+ F i F i]\no < i > o --> i\no < i > i --> i\n"
      "i < o > o --> o\ni < o > i --> i F i\ni < i > o --> o\ni < i > i --> o\n"
      "+ --> -\n- --> +";
  CHECK(after(text, 1) == "F i F o F i");
  CHECK(after(text, 2) == "F i F i F i F i");
  CHECK(after(text, 3) == "F i F o F o F i");
  CHECK(after(text, 4) == "F i F o F i[+F i F i]F i");
  CHECK(after(text, 5) == "F i F i F i F i[-F o F i]F i");
}

TEST_CASE(
    "contexts that do not match are tried in each step, and a text without steps derives until nothing is rewritten") {
  const BoundPointer bound = compiled("axiom: b a a a a\nb < a --> b");
  const Derived rest = sound(lsystem::develop(*bound, 1, {}, Limits{}));
  CHECK(text_of(*bound, rest) == "b b b b b");
  CHECK(rest.steps == 4);
  const std::string endless = error_of("axiom: b a\nb < a --> c\nc > * : * --> a\nb > a --> b\n");
  CHECK(contains(endless, "limit 0:0 The string is still being rewritten after 4096 steps"));
}

TEST_CASE("a random condition in context is drawn when its neighbour matches") {
  const char* text = "derivation length: 60\naxiom: b a a a\nb < a : ran(1)<0.5 --> b";
  const BoundPointer bound = compiled(text);
  const Derived first = derived(*bound, 60, 3);
  CHECK(text_of(*bound, first) == "b b b b");
  CHECK(first.steps > 3);
  // One of several by weight, each with another neighbour's parameter.
  const std::string many =
      after("axiom: A(1) B C(2)\nA(x) < B --> L(x) : 1\nB > C(y) --> R(y) : 1\nB > C(y) --> T(y) : 0", 1);
  CHECK((many == "A(1)L(1)C(2)" || many == "A(1)R(2)C(2)"));
  bool both[2] = {};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::string one =
        after("axiom: A(1) B C(2)\nA(x) < B --> L(x) : 1\nB > C(y) --> R(y) : 1\nB > C(y) --> T(y) : 0", 1, {}, seed);
    CHECK((one == "A(1)L(1)C(2)" || one == "A(1)R(2)C(2)"));
    both[one == "A(1)R(2)C(2)"] = true;
  }
  CHECK((both[0] && both[1]));
}

TEST_CASE("a context may match the environment's response") {
  Recorder environment;
  environment.answers = {{7}};
  const BoundPointer bound = compiled("axiom: A ?E(0)\nA > ?E(x) : x>0 --> B(x)\n?E(x) : x>0 --> %");
  lsystem::Derivation derivation(*bound, 1, Limits{});
  CHECK_FALSE(derivation.step());
  REQUIRE(derivation.query_environment({}, environment));
  CHECK(derivation.step());
  CHECK(lsystem::to_text(lsystem::program_of(*bound), derivation.string()) == "B(7)%");
}

TEST_CASE("errors of contexts have their place") {
  CHECK(contains(error_of("axiom: A\n< A --> B"), "syntax 2:1 Expected a context next to “<”"));
  CHECK(contains(error_of("axiom: A\nA > : 1 --> B"), "syntax 2:5 Expected a context next to “>”"));
  CHECK(contains(error_of("axiom: A\nA < B < C --> B"), "There is a second “<”"));
  CHECK(contains(error_of("axiom: A\nA > C < B --> D"), "syntax 2:3 Write the left context first"));
  CHECK(contains(error_of("axiom: A\n* A < B --> C"), "syntax 2:3 Write the left context first"));
  CHECK(contains(error_of("axiom: A\nFF < A --> B"), "syntax 2:1 “FF” is read as a single symbol"));
  CHECK(contains(error_of("axiom: A\np1: * < A > B --> C"), "syntax 2:1 In cpfg “p1:” labels a production"));
  CHECK(after("axiom: A\nA : * --> B", 1) == "B");
  CHECK(contains(error_of("axiom: A\nA [B] < C --> B"), "syntax 2:3 A left context cannot contain brackets"));
  CHECK(contains(error_of("axiom: A\nA > [B --> C"), "syntax 2:5 “[” is never closed"));
  CHECK(contains(error_of("axiom: A\nA > B] --> C"), "syntax 2:6 “]” has no matching opening bracket"));
  CHECK(contains(error_of("axiom: A\nA(x) < B(x) --> C"), "syntax 2:3 The parameter “x” appears twice"));
  CHECK(contains(error_of("axiom: A\nA < B > F(x,y) --> C"), "syntax 2:9"));
  CHECK(contains(error_of("axiom: A\nignore: A\nA < B --> C"), "syntax 3:1 Contexts ignore “A”"));
  CHECK(contains(error_of("axiom: A\nconsider: A\nA < B > C --> C"), "syntax 3:9 Contexts ignore “C”"));
  CHECK(
      contains(error_of("axiom: A\nignore: +\nconsider: A"), "syntax 3:1 There is a second “ignore:” or “consider:”"));
  CHECK(contains(error_of("axiom: A\nignore: AB"), "undefined 2:9 The grammar does not contain the symbol “AB”"));
  CHECK(contains(error_of("axiom: A\nignore: ["), "syntax 2:9 Contexts always match brackets"));
  CHECK(contains(error_of("axiom: A\nignore:"), "“ignore:” needs symbols"));
  CHECK(contains(error_of("axiom: A\nA < ?E(x) --> B"), "“?E” gets its response from the environment"));
  CHECK(contains(error_of("axiom: A\n#ignore A"), "“ignore: + - F”"));
  std::string many = "axiom: A\nA > ";
  for (int i = 0; i < 65; ++i) many += "B ";
  CHECK(contains(error_of(many + "--> C"), "limit 2:133 A context can have at most 64 modules"));
  std::string names;
  for (int i = 0; i < 20; ++i) names += (i ? "," : "") + std::string("a") + std::to_string(i);
  std::string others = names;
  std::replace(others.begin(), others.end(), 'a', 'b');
  CHECK(contains(error_of("axiom: A\nA(" + names + ") < B(" + others + ") --> C"), "limit 2:"));
}

TEST_CASE("matching contexts counts as work") {
  // Each of these looks to the end of the string.
  std::string text = "ignore: a\na > z --> b\naxiom: z ";
  for (int i = 0; i < 2000; ++i) text += "a ";
  Limits limits;
  CHECK(trouble(text, {}, limits) == "none");
  limits.work = 50000;
  CHECK(trouble(text, {}, limits) == "limit 0:0");
  // Each looks past all others for a branch.
  CHECK(trouble("ignore: a\na > [z] --> b\naxiom: " + text.substr(text.find("a a")) + "[x]", {}, limits) ==
        "limit 0:0");
  // Chance keeps it going, and each step goes through the string to the last module.
  std::string long_way = "derivation length: 4000\nz < y : ran(1)<0 --> b\naxiom: ";
  for (int i = 0; i < 2000; ++i) long_way += "a ";
  CHECK(trouble(long_way + "y", {}, limits) == "limit 0:0");
}

TEST_CASE("random trees are rewritten as an oracle rewrites them that goes through trees") {
  std::size_t rewritten = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Dice dice(seed);
    const std::string passed = dice.below(2) ? "d" : "";
    std::vector<Rule> rules;
    std::string text;
    if (!passed.empty()) text += "ignore: d\n";
    for (std::size_t i = 0; i < 6; ++i) {
      Rule rule{dice.letters(2), dice.tree(4), "abc"[dice.below(3)], "abcd"[dice.below(4)]};
      if (!passed.empty()) {
        std::erase(rule.left, 'd');
        std::erase(rule.right, 'd');
      }
      if (rule.right.find("[]") != std::string::npos) rule.right.clear();
      text += (rule.left.empty() ? "" : spaced(rule.left) + "< ") + rule.letter +
              (rule.right.empty() ? "" : " > " + spaced(rule.right)) + " --> " + rule.becomes + "\n";
      rules.push_back(rule);
    }
    std::string string = "ad" + dice.tree(60);
    const BoundPointer bound = compiled(text + "axiom: " + spaced(string));
    Oracle oracle(rules, passed);
    for (std::uint32_t step = 1; step < 5; ++step) {
      const std::string next = oracle.step(read_axis(string));
      rewritten += next != string;
      string = next;
      INFO(text, seed);
      CHECK(without_spaces(text_of(*bound, derived(*bound, step))) == string);
    }
  }
  CHECK(rewritten > 400);
}
