import { expect, it } from "vitest";
import { readout } from "../../../../../web/src/models/bunch/ui/readout";
import { BUNCH, specimenFromPreset, withParameters } from "../../../bunch";
import { makeGrown, SKETCH } from "../fixture";

/** Returns a template's text without tags. */
function textOf(drawn: unknown): string {
	if (Array.isArray(drawn)) return drawn.map(textOf).join("");
	const { strings, values } = (drawn ?? {}) as { strings?: readonly string[]; values?: readonly unknown[] };
	if (!strings) return typeof drawn === "symbol" ? "" : String(drawn ?? "");
	return strings.map((text, i) => text + textOf(values?.[i])).join("");
}

it("shows lengths of the outline in millimetres", () => {
	const specimen = withParameters(specimenFromPreset("riesling"), { l: 400, unit: 0.5 });
	const grown = makeGrown(SKETCH);
	const words = textOf(readout(grown, specimen)).replaceAll(/<[^>]*>/g, " ");
	const { px = 0 } = BUNCH.lengths?.(specimen) ?? {};
	expect(words).toContain(` ${Math.round(10 * 400 * px) / 10} mm`);
	expect(textOf(readout(grown, specimen))).not.toMatch(/pixel|\bpx\b/);
});
