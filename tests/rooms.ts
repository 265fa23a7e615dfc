/** Which room may use which: what tests/architecture.test.ts holds the sources to. */

/** Rooms of the core, each after those it may include. */
export const coreRooms = [
	"foundation",
	"geometry",
	"generalized_map",
	"environment",
	"lsystem",
	"plant",
	"models",
	"boundary",
];

/** What each room of web/src may import besides itself. `models` is the interface and the index. */
export const beforeModels = ["core", "specimen", "targets", "plant", "controls", "scene", "export"];
export const webRooms: Record<string, string[]> = {
	core: [],
	specimen: ["core"],
	targets: ["specimen"],
	plant: ["core"],
	controls: ["core", "specimen", "plant"],
	scene: ["core", "plant"],
	export: ["core", "specimen", "plant"],
	models: beforeModels,
	files: [...beforeModels, "models"],
	batch: [...beforeModels, "models", "files"],
	library: [...beforeModels, "models", "files", "batch"],
	service: [...beforeModels, "models", "files", "batch"],
	offline: ["core", "service"],
	element: [...beforeModels, "models", "files"],
	studio: [...beforeModels, "models", "files", "batch", "element", "offline"],
	cli: ["core", "specimen", "targets", "plant", "export", "models", "files", "batch", "library"],
};

/** Rooms that say where the built core lies; the others get it from them. */
export const knowBuild = ["core", "element", "studio", "cli", "service"];
