// Made from wasm-core/parameters/turtle.json and language.json by wasm-core/tools/generate.mjs; edit the tables, not this.

/** What the notation of grammars knows: the turtle's symbols, what begins a statement, functions. */
export interface Word {
	readonly kind: "symbol" | "statement" | "function";
	readonly name: string;
	/** With its arguments. */
	readonly written: string;
	/** What a symbol is called. */
	readonly title?: string;
	readonly help: string;
}

export const WORDS: readonly Word[] = [
	{
		kind: "symbol",
		name: "F",
		written: "F(s)",
		title: "line",
		help: "Move ahead by s and draw a line. Length 0 draws nothing.",
	},
	{
		kind: "symbol",
		name: "f",
		written: "f(s)",
		title: "move",
		help: "Move ahead by s without drawing.",
	},
	{
		kind: "symbol",
		name: "S",
		written: "S(i)",
		title: "sphere",
		help: "Move ahead by i and draw a sphere of radius i there. Radius 0 draws nothing.",
	},
	{
		kind: "symbol",
		name: "+",
		written: "+(θ)",
		title: "turn right",
		help: "Turn about the up axis, clockwise: the heading goes towards the right.",
	},
	{
		kind: "symbol",
		name: "-",
		written: "-(θ)",
		title: "turn left",
		help: "Turn about the up axis, counter-clockwise: the heading goes towards the left.",
	},
	{
		kind: "symbol",
		name: "&",
		written: "&(φ)",
		title: "pitch up",
		help: "Turn about the left axis, clockwise: the heading goes towards the up axis.",
	},
	{
		kind: "symbol",
		name: "^",
		written: "^(φ)",
		title: "pitch down",
		help: "Turn about the left axis, counter-clockwise: the heading goes away from the up axis.",
	},
	{
		kind: "symbol",
		name: "/",
		written: "/(ψ)",
		title: "roll right",
		help: "Roll about the heading, clockwise: the left axis goes away from the up axis.",
	},
	{
		kind: "symbol",
		name: "\\",
		written: "\\(ψ)",
		title: "roll left",
		help: "Roll about the heading, counter-clockwise: the left axis goes towards the up axis.",
	},
	{
		kind: "symbol",
		name: "|",
		written: "|",
		title: "turn around",
		help: "Turn about the up axis by 180°.",
	},
	{
		kind: "symbol",
		name: "!",
		written: "!(w)",
		title: "width",
		help: "Set the width of the lines to come.",
	},
	{
		kind: "symbol",
		name: "[",
		written: "[",
		title: "push",
		help: "Begin a branch: remember where the turtle is.",
	},
	{
		kind: "symbol",
		name: "]",
		written: "]",
		title: "pop",
		help: "End a branch: go back to where it began.",
	},
	{
		kind: "symbol",
		name: "%",
		written: "%",
		title: "cut",
		help: "Remove what follows, up to the end of the branch.",
	},
	{
		kind: "symbol",
		name: "?E",
		written: "?E(…)",
		title: "ask",
		help: "Ask the environment, then apply the first production of ?E that matches its answer, in place.",
	},
	{
		kind: "statement",
		name: "#define",
		written: "#define name value",
		help: "A constant. It may use names from lines above; a comment behind it, /* 0 … 90 */, is the range of its slider.",
	},
	{
		kind: "statement",
		name: "#input",
		written: "#input name",
		help: "A number, or with [] a list of numbers, that has to be given when the grammar is grown.",
	},
	{
		kind: "statement",
		name: "#role",
		written: "#role name symbols",
		help: "What the symbols are to the model that grows the grammar.",
	},
	{
		kind: "statement",
		name: "axiom:",
		written: "axiom: modules",
		help: "The string to begin with. There is exactly one.",
	},
	{
		kind: "statement",
		name: "derivation length:",
		written: "derivation length: steps",
		help: "How many steps the grammar takes.",
	},
	{
		kind: "statement",
		name: "ignore:",
		written: "ignore: symbols",
		help: "Symbols that contexts pass over.",
	},
	{
		kind: "statement",
		name: "consider:",
		written: "consider: symbols",
		help: "The symbols that alone are seen by contexts.",
	},
	{
		kind: "statement",
		name: "-->",
		written: "left < predecessor > right : condition --> successor : weight",
		help: "A production: what stands before the arrow becomes what stands behind it.",
	},
	{
		kind: "function",
		name: "RND",
		written: "RND(a, b)",
		help: "A random whole number from a to b, both included.",
	},
	{
		kind: "function",
		name: "ran",
		written: "ran(x)",
		help: "A random number from 0 up to, but not including, x.",
	},
	{
		kind: "function",
		name: "nran",
		written: "nran(m, d)",
		help: "A random number, normally distributed about m with standard deviation d.",
	},
	{
		kind: "function",
		name: "floor",
		written: "floor(x)",
		help: "The whole number below.",
	},
	{
		kind: "function",
		name: "ceil",
		written: "ceil(x)",
		help: "The whole number above.",
	},
	{
		kind: "function",
		name: "nearest",
		written: "nearest(x)",
		help: "The nearest whole number; halves go up.",
	},
	{
		kind: "function",
		name: "abs",
		written: "abs(x)",
		help: "Without its sign.",
	},
	{
		kind: "function",
		name: "min",
		written: "min(x, y)",
		help: "The lesser of two.",
	},
	{
		kind: "function",
		name: "max",
		written: "max(x, y)",
		help: "The greater of two.",
	},
	{
		kind: "function",
		name: "clamp",
		written: "clamp(x, low, high)",
		help: "x, but no less than low and no more than high.",
	},
	{
		kind: "function",
		name: "sqrt",
		written: "sqrt(x)",
		help: "The square root.",
	},
	{
		kind: "function",
		name: "pow",
		written: "pow(x, y)",
		help: "x to the power of y.",
	},
	{
		kind: "function",
		name: "exp",
		written: "exp(x)",
		help: "e to the power of x.",
	},
	{
		kind: "function",
		name: "log",
		written: "log(x)",
		help: "The natural logarithm.",
	},
	{
		kind: "function",
		name: "sin",
		written: "sin(x)",
		help: "The sine of an angle in degrees.",
	},
	{
		kind: "function",
		name: "cos",
		written: "cos(x)",
		help: "The cosine of an angle in degrees.",
	},
	{
		kind: "function",
		name: "tan",
		written: "tan(x)",
		help: "The tangent of an angle in degrees.",
	},
	{
		kind: "function",
		name: "asin",
		written: "asin(x)",
		help: "The angle in degrees whose sine x is.",
	},
	{
		kind: "function",
		name: "acos",
		written: "acos(x)",
		help: "The angle in degrees whose cosine x is.",
	},
	{
		kind: "function",
		name: "atan",
		written: "atan(x)",
		help: "The angle in degrees whose tangent x is.",
	},
	{
		kind: "function",
		name: "atan2",
		written: "atan2(y, x)",
		help: "The direction of the point (x, y), in degrees.",
	},
];
