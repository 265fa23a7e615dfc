/** The profile and its handles, flat and in 3-D. */
const SRC = "web/src/models/bunch/profile";
const TESTS = "tests/web/models/bunch/profile";

export default [
	{
		file: `${SRC}/handle_ray.ts`,
		suites: [`${TESTS}/handle_ray.test.ts`],
		faults: [
			{
				id: "ray-handle-behind-the-eye",
				find: "if (slant * alongLine < alongRay) return undefined;",
				replace: "",
				breaks: "a handle behind the eye jumps",
			},
			{
				id: "ray-plane-behind-the-eye",
				find: "if (!(distance > 0) || !Number.isFinite(distance)) return undefined;",
				replace: "if (!Number.isFinite(distance)) return undefined;",
				breaks: "a pointer above the horizon throws the handle far away",
			},
			{
				id: "ray-of-unit-length-only",
				find: "const towards = direction.map((value) => value / size)",
				replace: "const towards = direction.map((value) => value * 1)",
				breaks: "handles run away from the pointer as the view zooms",
			},
			{
				id: "ray-freedom-of-unit-length-only",
				find: "> GRAZING * size) return",
				replace: "> GRAZING) return",
				breaks: "a handle seen edge-on jumps by metres",
			},
		],
	},
	{
		file: `${SRC}/drag.ts`,
		suites: [`${TESTS}/drag.test.ts`],
		faults: [
			{
				id: "drag-side-crosses-the-axis",
				find: "SIDES[handle].sign * x, options)",
				replace: "Math.abs(x), options)",
				breaks: "a handle dragged across the axis grows on",
			},
			{
				id: "drag-locks-unheeded",
				find: "if (!locks?.[lock]) continue;",
				replace: "continue;",
				breaks: "locked sides go apart",
			},
		],
	},
	{
		file: `${SRC}/view_frame.ts`,
		suites: [`${TESTS}/view_frame.test.ts`],
		faults: [
			{
				id: "scale-one-centimetre-as-millimetres",
				find: "const label = length >= 10 ?",
				replace: "const label = length > 10 ?",
				breaks: "the scale bar says 10 mm where it says 1 cm",
			},
			{
				id: "extent-forgets-the-berry",
				find: "let neededHeight = shape.l + reach;",
				replace: "let neededHeight = shape.l;",
				breaks: "the lowest berry is cut off by the view",
			},
		],
	},
	{
		file: `${SRC}/envelope.ts`,
		suites: [`${TESTS}/envelope.test.ts`, `${TESTS}/outline_volume.test.ts`],
		faults: [
			{
				id: "outline-natural-as-paper",
				find: "natural ? naturalEndReach(parameters) : paperEndReach(parameters, w)",
				replace: "paperEndReach(parameters, w)",
				breaks: "the drawn outline is not the one that is filled",
			},
			{
				id: "outline-shoulder-of-the-first",
				find: "const axis = r * AXES_PER_PIXEL + first + 1;",
				replace: "const axis = r * AXES_PER_PIXEL + 1;",
				breaks: "the drawn waist stands too high at the back",
			},
		],
	},
	{
		file: `${SRC}/silhouette.ts`,
		suites: [`${TESTS}/silhouette.test.ts`],
		faults: [
			{
				id: "silhouette-side-from-the-right",
				find: "side: { right: 2, eye: 0, towards: -1 }",
				replace: "side: { right: 2, eye: 0, towards: 1 }",
				breaks: "in the side view far berries hide near ones",
			},
			{
				id: "silhouette-turn-reversed",
				find: "Math.atan2(-up, across)",
				replace: "Math.atan2(up, across)",
				breaks: "outlines of leaning fingers lean the other way",
			},
		],
	},
	{
		file: `${SRC}/silhouette_canvas.ts`,
		suites: [`${TESTS}/silhouette_canvas.test.ts`],
		faults: [
			{
				id: "silhouette-see-through",
				find: 'pen.globalCompositeOperation = "destination-out";',
				replace: "",
				breaks: "berries of the flat views are filled with ink",
			},
			{
				id: "silhouette-stale",
				find: "return [scene.bunch, scene.view,",
				replace: "return [scene.view,",
				breaks: "a flat view keeps the bunch before",
			},
		],
	},
	{
		file: `${SRC}/steady_extent.ts`,
		suites: [`${TESTS}/steady_extent.test.ts`],
		faults: [
			{
				id: "extent-changes-in-the-hand",
				find: 'const resting = motion !== "held" &&',
				replace: "const resting =",
				breaks: "the view rescales under a drag",
			},
		],
	},
	{
		file: `${SRC}/octahedron.ts`,
		suites: [`${TESTS}/octahedron.test.ts`],
		faults: [
			{
				id: "octahedron-orbits-while-dragged",
				find: "this.#host.setControlsEnabled(false);",
				replace: "",
				breaks: "the bunch turns under a dragged handle",
			},
			{
				id: "octahedron-finds-the-mirrored-handle",
				find: "x: ((position.x + 1) / 2) * box.width,",
				replace: "x: ((1 - position.x) / 2) * box.width,",
				breaks: "handles are taken hold of at the wrong side",
			},
			{
				id: "octahedron-hidden-handles-held",
				find: "if (!this.#parameters || !this.object.visible) return undefined;",
				replace: "if (!this.#parameters) return undefined;",
				breaks: "handles that are not shown can be dragged",
			},
		],
	},
	{
		file: `${SRC}/octahedron_renderer.ts`,
		suites: [`${TESTS}/octahedron.test.ts`],
		faults: [
			{
				id: "octahedron-handles-stay-behind",
				find: "this.#handles.get(handle)?.position.set(...place);",
				replace: "",
				breaks: "all handles stand at the top",
			},
		],
	},
	{
		file: "web/src/models/bunch/profile/profile_drawing.ts",
		suites: ["tests/web/models/bunch/profile/profile_drawing.test.ts"],
		faults: [
			{
				id: "profile-drawing-handles-for-own",
				find: "envelopePath({ ...parameters, ...own }, view)",
				replace: "envelopePath({ ...own, ...parameters }, view)",
				breaks: "a seed's own outline is drawn as the handles'",
			},
		],
	},
	{
		file: "web/src/models/bunch/ui/cane.ts",
		suites: ["tests/web/models/bunch/ui/cane.test.ts"],
		faults: [
			{
				id: "cane-leaves-stay",
				find: "{ cane: 0, leaves: 0 }",
				replace: "{ cane: 0 }",
				breaks: "the button takes a cane off that its leaves bring back",
			},
		],
	},
	{
		file: "web/src/models/bunch/ui/sides.ts",
		suites: ["tests/web/models/bunch/ui/sides.test.ts"],
		faults: [
			{
				id: "sides-lock-brings-nothing",
				find: "if (!locks[pair]) context.set(",
				replace: "if (locks[pair]) context.set(",
				breaks: "a lock leaves the sides apart",
			},
			{
				id: "sides-mirror-of-the-other-pair",
				find: 'pair === "leftRight" ? mirrorLeftRight(parameters) : mirrorFrontBack(parameters)',
				replace: 'pair === "leftRight" ? mirrorFrontBack(parameters) : mirrorLeftRight(parameters)',
				breaks: "mirror exchanges the wrong sides",
			},
		],
	},
	{
		file: "web/src/models/bunch/ui/thinning.ts",
		suites: ["tests/web/models/bunch/ui/thinning.test.ts"],
		faults: [
			{
				id: "thinning-of-bare-stems",
				find: "on && isNatural(specimen) && !context.toolState(stems)",
				replace: "on && isNatural(specimen)",
				breaks: "a click on bare stems takes off a berry that is not seen",
			},
		],
	},
	{
		file: "web/src/models/bunch/words.ts",
		suites: ["tests/web/models/bunch/words.test.ts"],
		faults: [
			{
				id: "words-flowers-as-berries",
				find: "specimen.parameters.age < FRUIT_SET",
				replace: "specimen.parameters.age < 0",
				breaks: "flowers are called berries",
			},
			{
				id: "words-length-without-radii",
				find: "bottom = Math.min(bottom, berries.spheres[at + 1] - berries.spheres[at + 3]);",
				replace: "bottom = Math.min(bottom, berries.spheres[at + 1]);",
				breaks: "bunches are said to be a berry shorter than they are",
			},
		],
	},
];
