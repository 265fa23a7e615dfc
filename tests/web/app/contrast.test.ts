/** Contrast of the page's colours, from the tokens of both themes (WCAG 1.4.3, 1.4.11 and, with more contrast, 1.4.6). */
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

type Theme = "light" | "dark";
type Colours = Readonly<Record<string, Readonly<Record<Theme, string>>>>;

const SHEET = readFileSync("web/src/app/style/tokens.css", "utf8");
const TOKEN = /--([\w-]+): (?:light-dark\((#\w+), (#\w+)\)|(#\w+));/g;

/** Reads the colours of a style sheet; other tokens are left out. */
function coloursIn(css: string): Colours {
	return Object.fromEntries(
		[...css.matchAll(TOKEN)].map(([, name, light, dark, both]) => [name, { light: light ?? both, dark: dark ?? both }]),
	);
}

const [standard, more] = SHEET.split("@media (prefers-contrast: more)").map(coloursIn);

/** Relative luminance of `#rgb` or `#rrggbb`, as WCAG defines it. */
function luminance(hex: string): number {
	const digits = hex.length === 4 ? [...hex.slice(1)].map((digit) => digit + digit) : (hex.slice(1).match(/../g) ?? []);
	const [r, g, b] = digits
		.map((digit) => Number.parseInt(digit, 16) / 255)
		.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
	return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(one: string, other: string): number {
	const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
	return (high + 0.05) / (low + 0.05);
}

const PAPERS = ["paper", "paper-raised", "paper-sunk"];
/** Backgrounds of each colour that is used for text. */
const TEXTS: Readonly<Record<string, readonly string[]>> = {
	ink: [...PAPERS, "wine-wash", "lit-wash", "code-selected"],
	"ink-soft": [...PAPERS, "wine-wash", "lit-wash", "code-selected"],
	wine: [...PAPERS, "wine-wash"],
	"on-wine": ["wine-fill"],
	"on-lit": ["lit"],
	"code-symbol": [...PAPERS, "lit-wash", "code-selected"],
	"code-number": [...PAPERS, "lit-wash", "code-selected"],
	"code-function": [...PAPERS, "lit-wash", "code-selected"],
	"code-error": PAPERS,
};
/** Backgrounds of each colour of borders, fills and marks that a control needs to be found. */
const MARKS: Readonly<Record<string, readonly string[]>> = {
	edge: [...PAPERS, "wine-wash", "lit-wash"],
	wine: PAPERS,
	"wine-fill": PAPERS,
	gesture: PAPERS,
	lit: PAPERS,
};

/** The pairs below a limit: "edge on paper (light): 2.98". */
function weak(colours: Colours, pairs: Readonly<Record<string, readonly string[]>>, least: number): string[] {
	const themes = ["light", "dark"] as const;
	return Object.entries(pairs).flatMap(([name, grounds]) =>
		grounds.flatMap((ground) =>
			themes.flatMap((theme) => {
				const ratio = contrast(colours[name][theme], colours[ground][theme]);
				return ratio < least ? [`${name} on ${ground} (${theme}): ${ratio.toFixed(2)}`] : [];
			}),
		),
	);
}

describe("colours of the page", () => {
	it("have known contrasts at both ends of the scale", () => {
		expect(contrast("#fff", "#000000")).toBeCloseTo(21, 5);
		expect(contrast("#767676", "#ffffff")).toBeCloseTo(4.54, 2);
	});

	it("give text a contrast of 4.5 to 1 on every background it has", () => {
		expect(weak(standard, TEXTS, 4.5)).toEqual([]);
	});

	it("give borders and marks of controls a contrast of 3 to 1", () => {
		expect(weak(standard, MARKS, 3)).toEqual([]);
	});

	it("give text 7 to 1 and controls 4.5 to 1 for visitors who prefer more contrast", () => {
		const colours = { ...standard, ...more };
		expect(weak(colours, TEXTS, 7)).toEqual([]);
		expect(weak(colours, MARKS, 4.5)).toEqual([]);
	});
});

/** Rules whose border belongs to a control, of the style sheets of the page. */
const CONTROLS =
	/(?:^|[\s,(])(?:input|select|textarea)(?=[\s,:.)[]|$)|\.button(?![\w-])|\.segments\b|\.switch\b|-field\b|-list\b/;

describe("borders of controls", () => {
	it("never use the colour of lines that only divide", () => {
		const sheets = ["bar", "base", "control", "gallery", "life", "overlay", "panel", "saved", "stage", "volume"];
		const found = sheets.flatMap((sheet) => {
			const css = readFileSync(`web/src/app/style/${sheet}.css`, "utf8");
			return [...css.matchAll(/([^{}]+)\{([^{}]*)\}/g)].flatMap(([, selector, body]) =>
				/border(?:-color)?: [^;]*--hairline/.test(body) && CONTROLS.test(selector.replace(/\/\*.*?\*\//gs, ""))
					? [`${sheet}: ${selector.trim()}`]
					: [],
			);
		});
		expect(found).toEqual([]);
	});
});
