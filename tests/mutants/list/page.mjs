/** Behaviour that only the built page shows: end-to-end tests. */
const E2E = "tests/e2e";

export default [
	{
		file: "web/index.html",
		suites: ["tests/web/app/policy.test.ts", `${E2E}/foreign.spec.ts: the page's own policy`],
		faults: [
			{
				id: "page-without-a-policy",
				find: '<meta http-equiv="Content-Security-Policy"',
				replace: '<meta name="policy"',
				breaks: "a text that found its way into the page may run as code",
			},
			{
				id: "page-policy-lets-styles-in",
				find: "style-src 'self';",
				replace: "style-src 'self' 'unsafe-inline';",
				breaks: "styles may be brought into the page",
			},
		],
	},
	{
		file: "web/src/models/bunch/profile/profile_view.ts",
		suites: [`${E2E}/shape.spec.ts: dragging a handle regrows the bunch`],
		faults: [
			{
				id: "profile-input-untold",
				find: 'this.emit("profile-input", { parameters });',
				replace: "",
				breaks: "a drag of a handle grows nothing",
			},
			{
				id: "profile-silent-after-a-key",
				find: "this.announce(handleValue(parameters, handle));",
				replace: "",
				suites: [`${E2E}/keys.spec.ts: a handle says where it stands`],
				breaks: "a screen reader hears nothing of a handle's step",
			},
			{
				id: "profile-deaf-to-double-clicks",
				find: "parameters[key] = this.initial[key];",
				replace: "parameters[key] = this.parameters[key];",
				suites: [`${E2E}/shape.spec.ts: a double click on a handle`],
				breaks: "a double click on a handle brings nothing back",
			},
		],
	},
	{
		file: "web/src/app/solid_view.ts",
		suites: [`${E2E}/thin.spec.ts: a click takes the berry under it off`],
		faults: [
			{
				id: "solid-view-picks-nothing",
				find: "return this.picksParts ? this.#view.pick(x, y) : undefined;",
				replace: "return undefined;",
				breaks: "no berry can be pointed at",
			},
		],
	},
	{
		file: "web/src/ui/number.ts",
		suites: [`${E2E}/shape.spec.ts: typed values are taken, clamped with a word`],
		faults: [
			{
				id: "number-clamped-unsaid",
				find: "if (Math.abs(typed - scale.per * value) <",
				replace: "return undefined;\n\tif (Math.abs(typed - scale.per * value) <",
				breaks: "a typed number changes without a word",
			},
		],
	},
	{
		file: "web/src/ui/held_key.ts",
		suites: [`${E2E}/shape.spec.ts: sliders work by keyboard`],
		faults: [
			{
				id: "held-key-a-step-each",
				find: "this.#held = true;",
				replace: "",
				breaks: "a held key leaves an undo step for each repeat",
			},
		],
	},
	{
		file: "web/src/app/shortcuts.ts",
		suites: [`${E2E}/gallery.spec.ts: letters typed into a field are no shortcuts`],
		faults: [
			{
				id: "shortcuts-while-typing",
				find: "if (isTyping(event)) return",
				replace: "if (false) return",
				breaks: "typing an n into the field of the seed grows another variation",
			},
		],
	},
	{
		file: "web/src/app/parts/notices.ts",
		suites: [`${E2E}/link.spec.ts: a malformed link opens what it can`],
		faults: [
			{
				id: "notices-not-dismissed",
				find: '("notice_dismiss")} @click',
				replace: '("notice_dismiss")} @dblclick',
				breaks: "notices cannot be sent away",
			},
		],
	},
	{
		file: "web/src/ui/typed.ts",
		suites: [`${E2E}/keys.spec.ts: a number is typed from its slider`],
		faults: [
			{
				id: "typed-digits-lost",
				find: "field?.select();",
				replace: "field?.blur();",
				breaks: "a number typed on a slider goes nowhere",
			},
		],
	},
	{
		file: "web/src/ui/pick_pointer.ts",
		suites: [`${E2E}/thin.spec.ts: a drag turns the bunch and takes nothing off`],
		faults: [
			{
				id: "thinning-by-a-drag",
				find: "if (this.#press && !near(this.#press, event)) this.#press = undefined;",
				replace: "",
				suites: [`${E2E}/thin.spec.ts: a drag turns the bunch and takes nothing off`],
				breaks: "turning the bunch takes berries off",
			},
		],
	},
	{
		file: "web/src/app/parts/speaker.ts",
		suites: [`${E2E}/solid_view.spec.ts: a screen reader announces the plant once it rests`],
		faults: [
			{
				id: "speaker-silent",
				find: "this.#summary = shown?.model.summary(shown.grown, shown.from);",
				replace: "",
				breaks: "a screen reader hears nothing of what grew",
			},
		],
	},
	{
		file: "web/src/render/viewer.ts",
		suites: [`${E2E}/solid_view.spec.ts: the 3-D view turns by mouse and keys`],
		faults: [
			{
				id: "viewer-draws-but-once",
				find: "if (!this.#canDraw) return;",
				replace: "if (!this.#canDraw || this.#rendered > 1) return;",
				breaks: "the picture stays as it first was",
			},
		],
	},
	{
		file: "web/src/app/parts/drop.ts",
		suites: [`${E2E}/files.spec.ts: GLB: valid, and dropped back it restores its bunch`],
		faults: [
			{
				id: "drop-nothing",
				find: "void takeFile(this.context, file);",
				replace: "",
				breaks: "dropped files do nothing",
			},
		],
	},
	{
		file: "web/lean_three.mjs",
		suites: ["tests/tools/lean_three.test.ts"],
		faults: [
			{
				id: "lean-three-draws-wrongly",
				find: "if (wrong) this.error(",
				replace: "if (!wrong) continue;\n\t\t\t\tif (false) this.error(",
				breaks: "a material whose program is left out is built, and draws nothing",
			},
			{
				id: "lean-three-nothing-left-out",
				find: 'unused.has(file) ? "" : bare(glsl)',
				replace: "bare(glsl)",
				breaks: "every visitor fetches the programs of all of three's materials",
			},
		],
	},
];
