/** Boundaries of trees and roots under hands, and the files that become one. */
const SRC = "web/src/models/particles";
const TESTS = "tests/web/models/particles/boundary";

export default [
	{
		file: "web/src/models/tree/layout.ts",
		suites: [`${TESTS}/grips.test.ts`],
		faults: [
			{
				id: "crown-below-ground-grows",
				find: "nearestWithin(TRUNK, Math.min(low, high - HEIGHT.min))",
				replace: "low",
				breaks: "a crown whose lower end is held below ground grows at every event",
			},
		],
	},
	{
		file: `${SRC}/boundary/editor/knot_grips.ts`,
		suites: [`${TESTS}/grips.test.ts`],
		faults: [
			{
				id: "end-knot-shrinks-the-box",
				find: "const y = share > 0 ? other + (to.y - other) / share : box[end];",
				replace: "const y = to.y;",
				breaks: "a profile that ends below its box's end shrinks at every touch",
			},
			{
				id: "reset-to-another-knot",
				find: "knots.length === before.length ?",
				replace: "before[index] ?",
				breaks: "a double click brings another point's place once points have been added",
			},
		],
	},
	{
		file: `${SRC}/boundary/editor/size_grips.ts`,
		suites: [`${TESTS}/grips.test.ts`],
		faults: [
			{
				id: "reset-to-the-presets-place",
				find: "end === fixedEnd ? presetBox[fixedEnd] : box[fixedEnd] + presetBox[end] - presetBox[fixedEnd]",
				replace: "presetBox[end]",
				breaks: "a double click on the top changes the height where the trunk is another",
			},
		],
	},
	{
		file: `${SRC}/boundary/editor/grip_drags.ts`,
		suites: [`${TESTS}/grip_drags.test.ts`],
		faults: [
			{
				id: "escape-brings-back-all",
				find: "restored: (_, before) => restrictedTo(before, lastChange),",
				replace: "",
				breaks: "Escape takes back what others changed during a drag",
			},
		],
	},
	{
		file: `${SRC}/boundary/editor/walls.ts`,
		suites: [`${TESTS}/grips.test.ts`],
		faults: [
			{
				id: "walls-out-of-reach",
				find: "Math.min(Math.max(far, -FARTHEST - wall[k]), FARTHEST - wall[k + 3])",
				replace: "far",
				breaks: "an obstacle is squeezed at the rim of what links hold",
			},
		],
	},
	{
		file: `${SRC}/boundary/details/places.ts`,
		suites: [`${TESTS}/details.test.ts`],
		faults: [
			{
				id: "boxes-and-rounds-apart",
				find: ", agree: limitTogether",
				replace: "",
				breaks: "sixteen boxes and a round one come through a link, and the core refuses them",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/stl.ts",
		suites: ["tests/web/import/mesh_file/mesh_file.test.ts"],
		faults: [
			{
				id: "stl-lies-on-its-back",
				find: "points.push(x, z, -y);",
				replace: "points.push(x, y, z);",
				breaks: "what was printed upright is an area that lies",
			},
			{
				id: "stl-solid-is-text",
				find: "if (count > 0 && bytes",
				replace: "if (count < 0 && bytes",
				breaks: "binary STLs hold no triangles",
			},
			{
				id: "stl-normals-are-corners",
				find: "12 * corner;",
				replace: "12 * (corner - 1);",
				breaks: "the first corner of every triangle is its normal",
			},
			{
				id: "stl-read-without-bound",
				find: "bounded(count);",
				replace: "",
				breaks: "a file of a million triangles is taken in before it is refused",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/glb.ts",
		suites: ["tests/web/import/mesh_file/mesh_file.test.ts"],
		faults: [
			{
				id: "children-are-roots",
				find: "rootNodes(gltf)",
				replace: "(gltf.nodes?.keys() ?? [])",
				breaks: "a GLB without scenes has its children twice",
			},
		],
	},
	{
		file: `${SRC}/boundary/grown_extent.ts`,
		suites: ["tests/web/models/tree/tree_renderer.test.ts"],
		faults: [
			{
				id: "young-looks-grown",
				find: 'table.option(specimen, "life") !== "grow"',
				replace: 'table.option(specimen, "life")',
				breaks: "a young tree fills the view as a grown one does, and nobody sees it grow",
			},
		],
	},
	{
		file: `${SRC}/boundary/wood_svg.ts`,
		suites: [`${TESTS}/wood_svg.test.ts`],
		faults: [
			{
				id: "svg-trunk-ends-at-a-twig",
				find: "energy[i] > energy[next[inner]]",
				replace: "true",
				breaks: "a trunk goes on in a twig",
			},
			{
				id: "svg-twigs-begin-in-the-trunk",
				find: "seen[0] === first && within > 0",
				replace: "false",
				breaks: "twigs are drawn from the middle of the trunk",
			},
		],
	},
	{
		file: "web/src/ui/same_document.ts",
		suites: ["tests/web/models/particles/late_files.test.ts"],
		faults: [
			{
				id: "late-file-changes-another-plant",
				find: "context.state.model === model && ",
				replace: "",
				breaks: "a mesh read late becomes a leaf's",
			},
		],
	},
];
