import { readFileSync, writeFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { type Description, described, lineOf, usual } from "../../../../../web/src/models/flower/design/description";
import { assembled } from "../../../../../web/src/models/flower/design/design";
import { moved, readMargin, writtenMargin } from "../../../../../web/src/models/flower/design/margin";
import { ORGANS, type Organ } from "../../../../../web/src/models/flower/design/organs";
import { fitOf, SHAPES } from "../../../../../web/src/models/flower/design/shapes";
import { elevation } from "../../../../../web/src/models/flower/ui/design/elevation";
import { floralDiagram, floralFormula } from "../../../../../web/src/models/flower/ui/design/floral_diagram";
import { outlineScene } from "../../../../../web/src/models/flower/ui/design/outline_scene";
import type { Scene, SceneHandle } from "../../../../../web/src/models/flower/ui/design/scene";
import { descriptionsOf, designedFlowers, diagrams } from "../../../../pictures/diagrams";

const shelf = designedFlowers();
const usually = descriptionsOf(assembled([usual("sepal", { count: 5 })]));

const handleIn = ({ handles }: Scene, id: string): SceneHandle => {
	const handle = handles.find((each) => each.id === id);
	if (!handle) throw new Error(`no ${id}`);
	return handle;
};

describe("handles of the flat views", () => {
	it("are at their organ's values: dragged to their own place they change nothing", () => {
		for (const { name, descriptions } of [...shelf, { name: "usual", descriptions: usually }])
			for (const organ of ORGANS)
				for (const scene of [floralDiagram(descriptions, organ), elevation(descriptions, organ)])
					for (const handle of scene.handles) {
						const before = descriptions.find(({ organ: each }) => handle.id.startsWith(each));
						expect(handle.pull(handle.at), `${name} ${handle.id}`).toEqual(before);
					}
	});

	it("are named each once, and go farther with Shift", () => {
		for (const organ of ORGANS)
			for (const scene of [floralDiagram(usually, organ), elevation(usually, organ), outlineScene(usually[3])]) {
				expect(new Set(scene.handles.map(({ label }) => label)).size).toBe(scene.handles.length);
				for (const handle of scene.handles)
					expect(
						[-1, 1].some((way) => lineOf(handle.nudge(way, 0, true)) !== lineOf(handle.nudge(way, 0, false))),
						handle.id,
					).toBe(true);
			}
	});

	it("count by how far round the second is: a third of the way is three, and past the first none", () => {
		const count = handleIn(floralDiagram(usually, "petal"), "petal-count");
		const radius = Math.hypot(count.at.x, count.at.y);
		const round = (degrees: number) => {
			const angle = (degrees * Math.PI) / 180;
			return count.pull({ x: -radius * Math.sin(angle), y: radius * Math.cos(angle) }).values.count;
		};
		expect([round(120), round(90), round(45), round(310), round(240), round(2)]).toEqual([3, 4, 8, 0, 1, 21]);
	});

	it("make more whorls the farther in the innermost is drawn, as far as there can be", () => {
		for (const [organ, most] of [
			["petal", 3],
			["stamen", 4],
		] as const) {
			const whorls = handleIn(floralDiagram(usually, organ), `${organ}-whorls`);
			const inwards = (by: number) => {
				const share = 1 - by / Math.hypot(whorls.at.x, whorls.at.y);
				return whorls.pull({ x: share * whorls.at.x, y: share * whorls.at.y }).values.whorls;
			};
			expect([inwards(-20), inwards(0), inwards(8), inwards(13), inwards(40)]).toEqual([1, 1, 2, 3, most]);
			expect([whorls.nudge(0, 1, false), whorls.nudge(-1, 0, true)].map(({ values }) => values.whorls)).toEqual([2, 1]);
		}
		// A calyx has one; without organs there is no whorl.
		expect(floralDiagram(usually, "sepal").handles.map(({ id }) => id)).not.toContain("sepal-whorls");
		const none = usually.map((each) => (each.organ === "petal" ? described(each, { count: 0 }) : each));
		expect(floralDiagram(none, "petal").handles.map(({ id }) => id)).not.toContain("petal-whorls");
	});

	it("lengthen and raise a petal by its tip, and bend it inwards by its middle", () => {
		const scene = elevation(usually, "petal");
		const tip = handleIn(scene, "petal-tip");
		const foot = handleIn(scene, "petal-foot").at;
		const out = { x: tip.at.x - foot.x, y: tip.at.y - foot.y };
		const before = usually[3].values;
		const twice = tip.pull({ x: foot.x + 2 * out.x, y: foot.y + 2 * out.y }).values;
		expect(twice.length).toBe(2 * Number(before.length));
		expect(twice.angle).toBe(before.angle);
		const turned = tip.pull({ x: foot.x - out.y, y: foot.y + out.x }).values;
		expect(Number(turned.angle)).toBeLessThan(Number(before.angle));
		const middle = handleIn(scene, "petal-bend");
		// Away from the axis and below the chord: the tip moves inwards.
		const bent = middle.pull({ x: middle.at.x + 3, y: middle.at.y + 3 }).values;
		expect(Number(bent.bend)).toBeLessThan(Number(before.bend));
	});

	it("turn an outline into a drawn one, whose points keep their order", () => {
		const scene = outlineScene(usually[3]);
		const point = handleIn(scene, "point-4");
		const drawn = point.pull({ x: point.at.x / 2, y: -1000 });
		expect(drawn.values.outline).toBe("drawn");
		const margin = drawn.margin ?? [];
		for (let i = 1; i < margin.length; i++) expect(margin[i].along).toBeGreaterThan(margin[i - 1].along);
		expect(readMargin(writtenMargin(margin))).toEqual(margin);
		fc.assert(
			fc.property(
				fc.nat(8),
				fc.double({ min: -2, max: 3, noNaN: true }),
				fc.double({ min: -2, max: 3, noNaN: true }),
				(i, along, out) => {
					const next = moved(margin, i, { along, out });
					expect(readMargin(writtenMargin(next))).toEqual(next);
				},
			),
		);
	});

	it("keep their order if edited text has them close to each other", () => {
		const margin = readMargin("0:0,0.5:1,0.51:0.9,0.5122:0.8,1:0") ?? [];
		for (const index of margin.keys())
			for (const along of [0, 0.5, 1]) {
				const next = moved(margin, index, { along, out: 0.7 });
				expect(next[index].out).toBe(0.7);
				expect(readMargin(writtenMargin(next)), `point ${index} to ${along}`).toEqual(next);
			}
	});

	it("is none where no margin is written", () => {
		for (const text of ["", "0:1", "0:1,1:2,2:1", "0:1,0.5:0.5,0.4:1,1:0", "0.2:1,0.5:1,1:1", "a:b,c:d,e:f"])
			expect(readMargin(text)).toBeUndefined();
	});
});

describe("a floral formula", () => {
	it("contains whorls, fused organs and irregular symmetry", () => {
		expect(floralFormula(usually)).toBe("✶ K5 C5 A5 G(3)");
		const set = (organ: Organ, values: Description["values"]) =>
			usually.map((each) => (each.organ === organ ? described(each, values) : each));
		expect(floralFormula(set("petal", { symmetry: "irregular", whorls: 2 }))).toBe("↓ K5 C5+5 A5 G(3)");
		expect(floralFormula(set("pistil", { fusion: "apocarpous" }))).toBe("✶ K5 C5 A5 G3");
		expect(floralFormula(set("sepal", { count: 0 }))).toBe("✶ P5 A5 G(3)");
		expect(floralFormula(set("stamen", { count: 0, whorls: 3 }))).toBe("✶ K5 C5 A0 G(3)");
	});
});

it("draws the stem and the bract whole: only middle lines are dashed", () => {
	const [{ descriptions }] = shelf;
	const kinds = floralDiagram(descriptions).lines.map(({ kind }) => kind);
	expect(kinds.filter((kind) => kind === "around")).toHaveLength(2);
	expect(kinds).not.toContain("axis");
	expect(elevation(descriptions).lines.map(({ kind }) => kind)).toContain("axis");
});

describe("the docs of designs", () => {
	it.each(diagrams())("have $path as `npm run pictures -- drawings` writes it", ({ path, text }) => {
		expect(readFileSync(path, "utf8")).toBe(text);
	});

	it("have the table of shapes as it is fitted (UPDATE_GOLDENS=1)", () => {
		const rows = Object.entries(SHAPES).map(([name, shape]) => {
			const { coefficients, error, even, fan } = fitOf(shape);
			const notes = [even && "even steps", fan > 0 && `foot turned back by ${fan}°`].filter(Boolean).join(", ");
			return `| ${name} | ${coefficients.join(" ")} | ${error.toFixed(3)} | ${notes} |`;
		});
		const page = "docs/models/flower/design.md";
		const before = readFileSync(page, "utf8");
		const now = before.replace(/(\|---\|---\|---\|---\|\n)(?:\|.*\n)*/, (_, head) => `${head}${rows.join("\n")}\n`);
		if (process.env.UPDATE_GOLDENS) writeFileSync(page, now);
		else expect(before).toBe(now);
	});
});
