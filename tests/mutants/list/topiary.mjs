/** Growth areas: containment, length of a path inside, text queries, and editing. */
const VOLUME = "tests/core/spatial/volume_test.cpp";
const AREAS = "tests/core/models/grammar/areas_test.cpp";
const EDITS = "tests/web/models/grammar/areas/edits.test.ts";
const DETAILS = "tests/web/models/grammar/areas/details.test.ts";

export default [
	{
		file: "wasm-core/src/spatial/volume.cpp",
		suites: [VOLUME],
		faults: [
			{
				id: "volume-cone-upside-down",
				find: "const float radius = 0.5f * (1 - u.y);",
				replace: "const float radius = 0.5f * (1 + u.y);",
				breaks: "a cone stands on its tip",
			},
			{
				id: "volume-reach-without-margin",
				find: "std::min(end - margin, most)",
				replace: "std::min(end + margin, most)",
				breaks: "tips stand out of their areas by what is rounded",
			},
			{
				id: "volume-turned-the-other-way",
				find: "to_local_rotation_(glm::conjugate(normalised(rotation)))",
				replace: "back_(sound(rotation))",
				breaks: "a turned area clips what it does not show",
			},
		],
	},
	{
		file: "wasm-core/src/spatial/solid.cpp",
		suites: [VOLUME],
		faults: [
			{
				id: "solid-leaves-at-inner-surfaces",
				find: "if (t > last && !inside(0.5f * (last + t))) return last;",
				replace: "if (t > last && last > 0) return last;",
				breaks: "a way ends where two parts of a mesh overlap",
			},
		],
	},
	{
		file: "wasm-core/src/models/grammar/areas.cpp",
		suites: [AREAS],
		faults: [
			{
				id: "areas-asked-in-metres",
				find: "return reached == wanted ? most : reached / metres_;",
				replace: "return reached;",
				breaks: "a text in millimetres is told of metres",
			},
			{
				id: "areas-with-the-first-mesh",
				find: "data = {data.points.subspan(3 * std::size_t{points}), data.triangles.subspan(3 * std::size_t{triangles})};",
				replace: "",
				breaks: "every mesh is the first one's",
			},
		],
	},
	{
		file: "wasm-core/src/models/grammar/area_membership.cpp",
		suites: [AREAS],
		faults: [
			{
				id: "belonging-outlasts-its-branch",
				find: "now = around.back();",
				replace: "",
				breaks: "what follows a branch belongs to the branch's area",
			},
		],
	},
	{
		file: "web/src/models/grammar/areas/area_handles.ts",
		suites: [EDITS],
		faults: [
			{
				id: "areas-widen-about-their-middle",
				find: "centre: sum(area.centre, scaled(axis, (width - area.size[k]) / 2)) });",
				replace: "centre: area.centre });",
				breaks: "the side opposite to the one in hand moves too",
			},
		],
	},
	{
		file: "web/src/models/grammar/details/areas.ts",
		suites: [DETAILS],
		faults: [
			{
				id: "areas-without-their-turn",
				find: 'return [kind, centre.join(","), size.join(","), ...turn].join(":");',
				replace: 'return [kind, centre.join(","), size.join(",")].join(":");',
				breaks: "a link forgets how areas are turned",
			},
		],
	},
	{
		file: "web/src/models/grammar/ui/warnings.ts",
		suites: ["tests/web/models/grammar/warnings.test.ts"],
		faults: [
			{
				id: "warnings-mark-the-next-area",
				find: "Number(area) - 1)",
				replace: "Number(area))",
				breaks: "the glass beside the area that is missed is red",
			},
			{
				id: "warnings-steps-unsaid",
				find: "&& done < requested ?",
				replace: "&& done > requested ?",
				breaks: "nobody learns that 12 of 60 steps are shown",
			},
			{
				id: "warnings-constants-of-every-object",
				find: "Object.hasOwn(constants, length) ? constants[length] : undefined",
				replace: "constants[length]",
				breaks: "a constant called constructor hides how many steps were asked for",
			},
			{
				id: "warnings-no-area-unsaid",
				find: "!specimen.areas?.length",
				replace: "specimen.areas?.length === 0",
				breaks: "a stub is left where the last area was, and no word",
			},
		],
	},
	{
		file: "web/src/render/shell_renderer.ts",
		suites: ["tests/web/render/shell_marks.test.ts"],
		faults: [
			{
				id: "shells-marked-by-their-parts",
				find: "marked.has(index >> 1)",
				replace: "marked.has(at)",
				breaks: "half of the wrong area is red",
			},
		],
	},
	{
		file: "web/src/models/grammar/areas/area_handles.ts",
		suites: [EDITS],
		faults: [
			{
				id: "area-handles-removed-for-good",
				find: "choice.removable ? { remove: change } : {}",
				replace: "{ remove: change }",
				breaks: "Delete takes an area from a page that has no way back",
			},
			{
				id: "area-turns-under-the-depth",
				find: "[-1, 0, 1],",
				replace: "[-1, 0, -1],",
				breaks: "a finger cannot choose between a turn and the depth",
			},
		],
	},
	{
		file: "wasm-core/src/models/grammar/areas.cpp",
		suites: ["tests/web/models/grammar/areas/topiary.test.ts"],
		faults: [
			{
				id: "topiary-one-fork-lost",
				find: "fork[last[before] - 1] = place;",
				replace: "fork[next[before] - 1] = place;",
				breaks: "of three branches of a fork the second is lost",
			},
			{
				id: "topiary-forks-share-areas",
				find: "if (volumes_[area - 1].contains(path_[i])) own[i] = area;",
				replace: "own[i] = area;",
				breaks: "all branches of a fork go to the first area, and the others stay bare",
			},
		],
	},
];
