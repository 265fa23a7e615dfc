/** Which folder may use which: tests/architecture.test.ts compares every include and import with this; docs/architecture.md draws it. */

/**
 * Folders of wasm-core/src that all models share, and the folders that each may include besides itself; `panicle_room`
 * in wasm-core/CMakeLists.txt links the same.
 */
export const coreRooms: Record<string, string[]> = {
	foundation: [],
	mesh: ["foundation"],
	spatial: ["foundation"],
	expression: ["foundation"],
	generalized_map: ["foundation", "mesh"],
	stems: ["foundation", "mesh"],
	light: ["foundation", "mesh", "spatial", "stems"],
	lsystem: ["foundation", "expression"],
	foliage: ["foundation", "mesh"],
	plant: ["foundation", "mesh", "stems"],
	protocol: ["foundation", "mesh", "foliage", "plant"],
	lsystem_plant: ["foundation", "mesh", "stems", "light", "expression", "lsystem", "plant", "protocol"],
};

/** Models of the core that are built on another's folder: leaf, root and tree share the engine of particles. */
export const coreModelUses: Record<string, string> = { leaf: "particles", root: "particles", tree: "particles" };

/** Folders that a model's folder may import. */
export const beforeModels = [
	"locale",
	"core",
	"specimen",
	"targets",
	"plant",
	"formats",
	"render",
	"ui",
	"grammar_editor",
	"import",
];

/**
 * Folders of web/src, and the folders that each may import besides itself, types included. `models` is the interface
 * and the index.
 */
export const webRooms: Record<string, string[]> = {
	locale: [],
	core: ["locale"],
	specimen: ["core", "locale"],
	plant: ["core", "locale"],
	targets: ["locale", "specimen"],
	formats: ["locale", "plant", "specimen"],
	render: ["locale", "plant"],
	ui: ["core", "locale", "plant", "specimen"],
	grammar_editor: ["core", "locale", "plant", "specimen", "ui"],
	import: ["core", "locale", "specimen", "ui"],
	models: beforeModels,
	generate: ["core", "formats", "locale", "models", "plant", "specimen"],
	batch: ["formats", "generate", "locale", "models", "plant", "specimen", "targets"],
	service: ["batch", "core", "formats", "generate", "locale", "models", "plant", "specimen"],
	library: ["batch", "core", "formats", "generate", "locale", "models", "plant", "render", "specimen", "targets"],
	offline: ["core", "locale", "service"],
	cli: ["batch", "core", "formats", "generate", "library", "locale", "models", "plant", "specimen", "targets"],
	element: ["core", "formats", "generate", "locale", "models", "plant", "render", "specimen", "ui"],
	app: [
		"batch",
		"core",
		"formats",
		"generate",
		"locale",
		"models",
		"offline",
		"plant",
		"render",
		"specimen",
		"targets",
		"ui",
	],
};

/** Models of the page that are built on another's folder. */
export const webModelUses: Record<string, string> = { leaf: "particles", root: "particles", tree: "particles" };

/** Folders that name the built core's files; the others get it from them. */
export const knowBuild = ["core", "element", "app", "cli", "service"];
