/** Stands: the plan, placements, surroundings, and members that grow alone. */
const SRC = "wasm-core/src/models/stand";
const TESTS = "tests/core/models/stand";
const WEB = "tests/web/models/stand";

export default [
	{
		file: `${SRC}/places.cpp`,
		suites: [`${TESTS}/places_test.cpp`],
		faults: [
			{
				id: "stand-blue-darts-come-near",
				find: "free = glm::distance(spots[static_cast<std::size_t>(spot)], dart) >= apart;",
				replace: "free = glm::distance(spots[static_cast<std::size_t>(spot)], dart) >= 0.5f * apart;",
				breaks: "plants stand nearer to each other than the plan says",
			},
			{
				id: "stand-seeds-do-not-make-alike",
				find: "if (kind.seeds > 0) {",
				replace: "if (false) {",
				breaks: "plants of a line with so many seeds all differ",
			},
			{
				id: "stand-last-plants-are-lost",
				find: "static_cast<std::uint32_t>(upto * requested / all - before * requested / all);",
				replace: "static_cast<std::uint32_t>((upto - before) * requested / all);",
				breaks: "fewer plants stand than were asked for",
			},
			{
				id: "stand-borne-on-the-ground",
				find: "const float height = host.scale * value_at(kind.high, draws.unit(8 * k + 5));",
				replace: "const float height = 0 * draws.unit(8 * k + 5);",
				breaks: "bunches lie on the ground",
			},
			{
				id: "stand-fewer-fill-the-back",
				find: "if (is_reduced) keep_middle(found, count);",
				replace: "if (is_reduced && found.size() > count) found.resize(count);",
				breaks: "a vineyard of few vines has them all in its rear rows",
			},
		],
	},
	{
		file: `${SRC}/surroundings.cpp`,
		suites: [`${TESTS}/surroundings_test.cpp`],
		faults: [
			{
				id: "stand-surroundings-do-not-turn",
				find: "const float azimuth = arc_tangent(way.y, way.x) * 180 / pi - plants[i].turn;",
				replace: "const float azimuth = arc_tangent(way.y, way.x) * 180 / pi;",
				breaks: "a turned plant takes its neighbours to be elsewhere",
			},
			{
				id: "stand-higher-crowns-are-passed-over",
				find: "if (!within && above <= lowest * near) return;",
				replace: "if (!within) return;",
				breaks: "a tall tree behind a near one hides no sky",
			},
			{
				id: "stand-room-as-if-at-scale-1",
				find: "/ sincos_degrees(from_axis).cosine / plants[i].scale);",
				replace: "/ sincos_degrees(from_axis).cosine);",
				breaks: "small plants grow as if they had less room than they have",
			},
			{
				id: "stand-surroundings-finer-than-links",
				find: "horizon[k] = std::floor(horizon[k] + 0.5f);",
				replace: "",
				breaks: "a plant opened alone is another than the one in the stand",
			},
		],
	},
	{
		file: "web/src/generate/members.ts",
		suites: [`${WEB}/members.test.ts`],
		faults: [
			{
				id: "stand-neighbours-are-not-told",
				find: "...{ model: model.name, preset, seed, surroundings },",
				replace: "...{ model: model.name, preset, seed },",
				breaks: "plants grow as if each stood alone",
			},
			{
				id: "members-told-what-they-do-not-know",
				find: 'details.some(({ keys }) => keys.includes("surroundings"))',
				replace: "true",
				breaks: "a bed notes of each flower that it knows of no neighbours, and grows all anew when one is moved",
				suites: [`${WEB}/bed.test.ts`],
			},
			{
				id: "stand-grown-anew-each-time",
				find: "if (done[at]) continue;",
				replace: "",
				breaks: "a change of the plan grows what has not changed once more",
			},
			{
				id: "stand-keeps-what-lacks-something",
				find: "if (read[at].prepared) cache",
				replace: "cache",
				breaks: "plants that lack what could not be fetched once lack it for ever",
			},
			{
				id: "stand-looks-of-its-own",
				find: "cache?.materials ?? new SharedMaterials()",
				replace: "new SharedMaterials()",
				breaks: "a file's bytes hang on what was edited before",
			},
		],
	},
	{
		file: "web/src/models/stand/words.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-bunches-are-plants",
				find: "const count = counts.plants - attached;",
				replace: "const count = counts.plants;",
				breaks: "a vineyard is said to have five times its vines",
			},
		],
	},
	{
		file: "web/src/specimen/surroundings.ts",
		suites: ["tests/web/specimen/surroundings.test.ts"],
		faults: [
			{
				id: "surroundings-not-in-links",
				find: 'surroundings ? [["about", surroundings.join(",")]] : []',
				replace: "[]",
				breaks: "a plant opened alone grows as if it had no neighbours",
			},
		],
	},
	{
		file: "web/src/core/pool.ts",
		suites: ["tests/web/core/pool.test.ts"],
		faults: [
			{
				id: "pool-keeps-all-workers",
				find: "for (const worker of workers) if (worker !== small) this.#terminate(worker);",
				replace: "",
				breaks: "a page that has grown a stand keeps the memory of all its workers",
			},
		],
	},
	{
		file: "web/src/formats/gltf_document.ts",
		suites: ["tests/web/formats/lod_glb.test.ts"],
		faults: [
			{
				id: "lod-without-coverage",
				find: "MSFT_screencoverage: coverage",
				replace: "",
				breaks: "engines do not know when to change the levels",
			},
		],
	},
	{
		file: "web/src/formats/glb.ts",
		suites: ["tests/web/formats/lod_glb.test.ts"],
		faults: [
			{
				id: "lod-levels-all-in-the-scene",
				find: "children.splice(1)",
				replace: "children.slice(1)",
				breaks: "who knows no levels shows four trees in each other",
			},
		],
	},
	{
		file: "web/src/models/stand/walker.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-walk-begins-in-a-crown",
				find: "if (room > best.room) best = { x, room };",
				replace: "if (i === 0) best = { x, room };",
				breaks: "who walks sees nothing but leaves",
			},
			{
				id: "stand-bunches-keep-walkers-off",
				find: "if (places.parent[plant] >= 0) continue;",
				replace: "",
				breaks: "a walk begins far aside of vines with bunches",
			},
			{
				id: "stand-walker-leaves-the-ground",
				find: "Math.min(0.5 * size, Math.max(-0.5 * size, value));",
				replace: "value + 0 * size;",
				breaks: "who walks on and on is nowhere",
			},
		],
	},
	{
		file: "wasm-core/src/models/stand/places.cpp",
		suites: ["tests/core/models/stand/places_test.cpp"],
		faults: [
			{
				id: "stand-middle-of-the-back",
				find: "!is_reduced ? i - rows : i % 2 == 0 ? i / 2 : -(i + 1) / 2",
				replace: "i - rows",
				breaks: "fewer plants than a large ground has places stand at its back",
			},
		],
	},
];
