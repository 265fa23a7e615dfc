/** Plants in other pages: the element's extras, frames, code to be copied, pictures with links. */
const EXTRAS = "tests/e2e/element_extras.spec.ts";

export default [
	{
		file: "web/src/formats/png_link.ts",
		suites: ["tests/web/formats/png_link.test.ts"],
		faults: [
			{
				id: "png-link-believed-though-damaged",
				find: "if (!whole) throw broken(name);",
				replace: "",
				breaks: "a picture whose link was damaged opens as another plant",
			},
			{
				id: "png-link-before-the-header",
				find: "const start = PNG_SIGNATURE.length + CHUNK_FRAME + 13;",
				replace: "const start = PNG_SIGNATURE.length;",
				breaks: "no other program opens the picture",
			},
		],
	},
	{
		file: "web/src/app/files/open.ts",
		suites: ["tests/web/app/open.test.ts"],
		faults: [
			{
				id: "picture-opens-without-its-model",
				find: "await modelNamed(modelInQuery(query))",
				replace: "await modelNamed()",
				breaks: "the picture of a tree opens as a bunch",
			},
		],
	},
	{
		file: "web/src/app/files/formats.ts",
		suites: ["tests/web/app/formats.test.ts"],
		faults: [
			{
				id: "picture-without-its-link",
				find: "withLink(await take(sizeOf(request)), request.link)",
				replace: "take(sizeOf(request))",
				breaks: "a downloaded picture brings no plant back",
			},
		],
	},
	{
		file: "web/src/app/files/embed_code.ts",
		suites: ["tests/web/app/embed_code.test.ts"],
		faults: [
			{
				id: "embed-code-lets-quotes-out",
				find: '.replaceAll(\'"\', "&quot;")',
				replace: "",
				breaks: "words with quotes end their attribute",
			},
			{
				id: "embed-code-without-wind",
				find: '["autorotate", "wind", "controls", "handles"]',
				replace: '["autorotate", "controls", "handles"]',
				breaks: "a plant that was to sway in its page stands still",
			},
			{
				id: "embed-frame-keys-in-the-fragment",
				find: "const { query, fragment } = linkParts(link);",
				replace: 'const { query, fragment } = { query: link, fragment: "" };',
				breaks: "a frame of a bunch with a text has no controls",
			},
		],
	},
	{
		file: "web/src/ui/handles/handle_ways.ts",
		suites: ["tests/web/ui/handles/handle_ways.test.ts"],
		faults: [
			{
				id: "handle-goes-along-the-sight",
				find: "firstDepth <= secondDepth ? along[0] : along[1]",
				replace: "firstDepth <= secondDepth ? along[1] : along[0]",
				breaks: "a handle whose plane is seen edge-on runs away from the pointer",
			},
			{
				id: "handle-behind-the-eye",
				find: "distance > 0 && Number.isFinite(distance)",
				replace: "Number.isFinite(distance)",
				breaks: "a handle behind the eye jumps",
			},
		],
	},
	{
		file: "web/src/models/leaf/outline/bent.ts",
		suites: ["tests/web/models/leaf/outline/bent.test.ts"],
		faults: [
			{
				id: "leaf-handles-curl-the-other-way",
				find: "(radius + z) * cosine - radius]",
				replace: "radius - (radius + z) * cosine]",
				breaks: "the handles of a curled leaf stand in the air",
			},
		],
	},
	{
		file: "web/src/models/bunch/profile/plant_handles.ts",
		suites: ["tests/web/models/plant_handles.test.ts"],
		faults: [
			{
				id: "bunch-handles-drop-upwards",
				find: "/ pixel, -y / pixel)",
				replace: "/ pixel, y / pixel)",
				breaks: "a handle drawn down goes up",
			},
		],
	},
	{
		file: "web/src/generate/plant_in_words.ts",
		suites: ["tests/web/generate/plant_in_words.test.ts"],
		faults: [
			{
				id: "element-says-no-kind",
				find: "if (title.toLowerCase().includes(plant))",
				replace: "if (title)",
				breaks: "a screen reader does not hear whether an oak is a leaf or a tree",
			},
		],
	},
	{
		file: "web/src/formats/file_options.ts",
		suites: ["tests/web/element/embed/conversation.test.ts"],
		faults: [
			{
				id: "frame-takes-any-number",
				find: "value >= least && value <= most",
				replace: "value >= least",
				breaks: "a page requests a million million points of a frame",
			},
		],
	},
	{
		file: "web/src/element/embed/conversation.ts",
		suites: ["tests/web/element/embed/conversation.test.ts"],
		faults: [
			{
				id: "frame-listeners-unlimited",
				find: "this.#listeners.size >= MAX_LISTENERS",
				replace: "false",
				breaks: "a page that makes frames without end has a plant hold them all",
			},
			{
				id: "frame-closed-listeners-kept",
				find: "if (listener.closed) this.#listeners.delete(listener);",
				replace: "",
				breaks: "windows that are closed take the places of those that are open",
			},
		],
	},
	{
		file: "web/src/element/embed/frame_settings.ts",
		suites: ["tests/web/element/embed/conversation.test.ts"],
		faults: [
			{
				id: "frame-origins-as-they-were-typed",
				find: "[new URL(address).origin]",
				replace: "[address]",
				breaks: "an allowed page with a slash behind it is kept out",
			},
		],
	},
	{
		file: "web/src/element/extras/bar.ts",
		suites: [`${EXTRAS}: the bar turns, ages, seeds`],
		faults: [
			{
				id: "bar-seed-forgotten",
				find: "interaction.edit((now) => withSeed(now, seed));",
				replace: "",
				breaks: "another seed in the bar grows nothing",
			},
		],
	},
	{
		file: "web/src/element/extras/handles_layer.ts",
		suites: [`${EXTRAS}: handles stand on the plant`],
		faults: [
			{
				id: "element-handles-stay-behind",
				find: "this.#stopFollowingDraws = view.onDrawn(() => this.#layer.place());",
				replace: "this.#stopFollowingDraws = () => {};",
				breaks: "handles stand still while the plant turns",
			},
		],
	},
	{
		file: "web/src/app/files/page_weight.ts",
		suites: ["tests/e2e/embed.spec.ts: copied code shows the plant"],
		faults: [
			{
				id: "embed-weight-unpacked",
				find: '.pipeThrough(new CompressionStream("gzip"))',
				replace: "",
				breaks: "the dialog says twice what a visitor downloads",
			},
		],
	},
	{
		file: "web/src/element/app_address.ts",
		suites: ["tests/web/element/app_address.test.ts"],
		faults: [
			{
				id: "app-address-runs-scripts",
				find: 'return protocol === "http:" || protocol === "https:" || protocol === own?.protocol ? href : undefined;',
				replace: "return protocol ? href : undefined;",
				breaks: "“Open in the app” runs a script that an attribute holds",
			},
		],
	},
	{
		file: "web/src/element/current_document.ts",
		suites: ["tests/web/element/current_document.test.ts"],
		faults: [
			{
				id: "element-failure-kept",
				find: "if (this.#current === next) this.#current = isBeforeGood ? before : undefined;",
				replace: "",
				breaks: "an element whose script did not come once never grows again",
			},
		],
	},
	{
		file: "web/src/element/commons.ts",
		suites: ["tests/web/element/commons.test.ts"],
		faults: [
			{
				id: "element-holds-no-scripts",
				find: "if (!this.#held) this.#options.hold();",
				replace: "",
				breaks: "an update of the app deletes scripts that an open frame has yet to fetch",
			},
		],
	},
];
