/** Handles and their drags, wherever they are. */
const SRC = "web/src/ui/handles";
const SESSION = "tests/web/ui/handles/drag_session.test.ts";
const PROFILE = "tests/web/models/bunch/profile";

export default [
	{
		file: `${SRC}/value_label.ts`,
		suites: ["tests/web/ui/handles/value_label.test.ts"],
		faults: [
			{
				id: "label-over-other-handles",
				find: "others.filter(covers).length",
				replace: "0",
				breaks: "the words beside a handle lie over other handles",
			},
			{
				id: "label-over-the-drawing",
				find: "+ 0.4 * inward",
				replace: "",
				breaks: "the words beside a handle lie over what is drawn",
			},
		],
	},
	{
		file: `${SRC}/drag_session.ts`,
		suites: [SESSION, `${PROFILE}/drag_session.test.ts`],
		faults: [
			{
				id: "session-before-of-the-second-finger",
				find: "this.#before ??= { state: this.#host.get() };",
				replace: "this.#before = { state: this.#host.get() };",
				breaks: "Escape brings back what was when the second finger came",
			},
			{
				id: "session-told-at-every-event",
				find: "if (this.#scheduled) return;",
				replace: "",
				breaks: "a fast mouse grows a plant for each of its thousand events",
			},
			{
				id: "session-drag-to-nowhere-is-a-step",
				find: "if (this.#host.same(before, state)) return;",
				replace: "",
				breaks: "a click on a handle is an undo step",
			},
			{
				id: "drag-jumps-to-the-pointer",
				find: "offset: { x: from.x - at.x, y: from.y - at.y }",
				replace: "offset: { x: 0, y: 0 }",
				breaks: "a handle taken at its rim jumps",
			},
		],
	},
	{
		file: `${SRC}/point.ts`,
		suites: [SESSION],
		faults: [
			{
				id: "drag-farthest-handle-meant",
				find: "if (!(distance <= least)) continue;",
				replace: "if (!(distance <= reach)) continue;",
				breaks: "of two handles close together the wrong one is taken",
			},
		],
	},
	{
		file: `${SRC}/escape_key.ts`,
		suites: [`${PROFILE}/octahedron.test.ts`],
		faults: [
			{
				id: "octahedron-deaf-to-escape",
				find: 'if (on) window.addEventListener("keydown", this.#onKey, { capture: true });',
				replace: "if (on) return;",
				breaks: "Escape calls off no drag in 3-D",
			},
		],
	},
];
