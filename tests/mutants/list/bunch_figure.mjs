/** The renderer of bunches: occlusion, data for the shaders, picking. */
const SRC = "web/src/models/bunch/render";
const TESTS = "tests/web/models/bunch/render";

export default [
	{
		file: `${SRC}/casters.ts`,
		suites: [`${TESTS}/casters.test.ts`],
		faults: [
			{
				id: "casters-shade-from-behind",
				find: "if (along <= -radius) continue;",
				replace: "if (along >= radius) continue;",
				breaks: "berries are shaded by those behind them",
			},
			{
				id: "casters-narrow-column",
				find: "extent + reach * (1 + 16 * spread), found)",
				replace: "0.1 * (extent + reach), found)",
				breaks: "most shadows are missing",
			},
			{
				id: "casters-never-anew",
				find: "if (before?.receivers === receivers && isSameLamp(before.lamp, lamp)) return false;",
				replace: "if (before) return false;",
				breaks: "shadows stay where they were when the bunch is turned",
			},
		],
	},
	{
		file: `${SRC}/depth_order.ts`,
		suites: [`${TESTS}/depth_order.test.ts`],
		faults: [
			{
				id: "depth-order-reversed",
				find: "this.#depths[a] - this.#depths[b]",
				replace: "this.#depths[b] - this.#depths[a]",
				breaks: "every pixel is drawn many times over",
			},
		],
	},
	{
		file: `${SRC}/receivers.ts`,
		suites: [`${TESTS}/receivers.test.ts`],
		faults: [
			{
				id: "receivers-fingers-as-balls",
				find: "if (!(ratio >= TWO_SPHERES)) {",
				replace: "if (ratio > 0) {",
				breaks: "fingers cast the shadows of balls",
			},
			{
				id: "receivers-own-shadow",
				find: "\t\t\towner.push(i);\n\t\t}",
				replace: "\t\t\towner.push(0);\n\t\t}",
				breaks: "long berries stand in their own shadow",
			},
		],
	},
	{
		file: `${SRC}/berry_skins.ts`,
		suites: [`${TESTS}/berry_skins.test.ts`],
		faults: [
			{
				id: "skins-normals-of-one-half",
				find: "if (z < 0) {",
				replace: "if (z < -2) {",
				breaks: "the backs of berries are lit as their fronts",
			},
		],
	},
	{
		file: `${SRC}/picking.ts`,
		suites: [`${TESTS}/picking.test.ts`],
		faults: [
			{
				id: "picking-the-farthest",
				find: "distance < nearestDistance) [nearest",
				replace: "distance > -1) [nearest",
				breaks: "a click takes off a berry behind the one under it",
			},
			{
				id: "picking-behind-the-eye",
				find: "return nearest > 0 ? nearest : undefined;",
				replace: "return nearest;",
				breaks: "berries behind the eye are found",
			},
		],
	},
	{
		file: `${SRC}/shadow_capsules.ts`,
		suites: [`${TESTS}/shadow_capsules.test.ts`],
		faults: [
			{
				id: "shadow-without-berries",
				find: "if (withBerries) addBerries(grown, begins, ends);",
				replace: "",
				breaks: "the shadow on the paper is of stems alone",
			},
		],
	},
	{
		file: `${SRC}/cached_sky.ts`,
		suites: [`${TESTS}/cached_sky.test.ts`],
		faults: [
			{
				id: "kept-sky-by-place",
				find: "const berryBefore = berriesBefore.get(id);",
				replace: "const berryBefore: number | undefined = berry;",
				breaks: "while a handle moves berries trade their shades when one before them goes",
			},
			{
				id: "kept-sky-of-any-stem",
				find: "const sameKind = byKindBefore.get(kind)?.filter(",
				replace: "const sameKind = byKindBefore.get(0)?.filter(",
				breaks: "while a handle moves pedicels are as bright as the peduncle",
			},
		],
	},
	{
		file: `${SRC}/bunch_renderer.ts`,
		suites: [`${TESTS}/bunch_renderer.test.ts`],
		faults: [
			{
				id: "figure-stems-with-berries",
				find: "this.#surface.bare = !whole;",
				replace: "this.#surface.bare = false;",
				breaks: "“stems only” shows the berries",
			},
		],
	},
];
