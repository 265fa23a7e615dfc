import { html, nothing, svg } from "lit";
import type { Plant } from "../plant/plant";
import type { WithGrammar } from "../specimen/grammar_text";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, Fault } from "../ui/editor_context";
import { BASICS, GROWTH_TOPIC, type Tool } from "../ui/tool";
import { type DerivationSource, derivationTool } from "./derivation_tool";
import { text } from "./messages.generated";
import { type GrammarSource, isOwn, withText } from "./source";

/** State of the editor that the page stores. */
export interface GrammarState {
	readonly open: boolean;
	/** Whether Tab indents in the editor. */
	readonly indents: boolean;
}

const GRAMMAR = svg`<path d="M7.5 4 3.5 10l4 6M12.5 4l4 6-4 6"/>`;

/** Panel group with a slider for each constant of the text. */
const CONSTANTS = {
	key: "constants",
	get title() {
		return text("constants");
	},
	get help() {
		return text("constants_help");
	},
} as const;

/**
 * Group for the notice at the panel's end: if handles and gestures write the text, the controls above must not move.
 */
const OWN = {
	key: "own-grammar",
	get title() {
		return text("grammar");
	},
	get help() {
		return text("own_help");
	},
	plain: true,
	last: true,
} as const;

/**
 * Tools for the grammar: the text editor, sliders for the text's constants, and the way back to the built-in text.
 * @param derived description for the step viewer; absent if the model has no derivation
 */
export function grammarTools<S extends Specimen & WithGrammar, G extends Plant>(
	source: GrammarSource<S>,
	derived?: DerivationSource<S, G>,
): readonly Tool<S, G>[] {
	const tool = editorTool<S, G>(source, derived !== undefined);
	const { group = OWN } = source;
	const drop = (context: EditorContext<S, G>) =>
		context.set(withText(source as unknown as GrammarSource, context.state.specimen, undefined));
	const own: Tool<S, G, boolean> = {
		name: "own-grammar",
		initial: false,
		applies: isOwn,
		// The built-in text is needed to decide whether the document's text is the preset's with other numbers.
		start: (context) => {
			const builtIn = group === OWN && isOwn(context.state.specimen) ? source.builtIn(context.state.specimen) : "";
			if (typeof builtIn !== "string")
				builtIn.then(
					() => context.setToolState(own, true),
					() => {},
				);
			return () => {};
		},
		panel: {
			group,
			place: "above",
			// The open editor shows this itself, with a button that restores the built-in text.
			draw: (context) =>
				context.toolState(tool).open
					? nothing
					: html`<div class="override">
					<p>${text("own_grammar")}</p>
					<div class="actions">
						<button class="button" type="button" @click=${() => openEditor(context, tool)}>${text("edit")}</button>
						<button class="button" type="button" @click=${() => drop(context)}>${text("discard")}</button>
					</div>
				</div>`,
		},
		remedies: [
			{
				get label() {
					return text("edit");
				},
				press: (context) => openEditor(context, tool),
			},
			{
				get label() {
					return text("discard");
				},
				press: drop,
			},
		],
	};
	return [
		tool as Tool<S, G>,
		...(derived ? [derivationTool(derived) as Tool<S, G>] : []),
		...constantTools<S, G>(source),
		own as Tool<S, G>,
	];
}

/** Returns the tools of the text's constants: some are among the basics, the others in a group of their own. */
function constantTools<S extends Specimen & WithGrammar, G extends Plant>(source: GrammarSource<S>): Tool<S, G>[] {
	const panel = (shown: "basics" | "others", context: EditorContext<S, G>) => {
		void bring(context, () => import("./constants"), text("sliders_not_loaded"));
		return html`<panicle-constants .context=${context} .source=${source} .shown=${shown}></panicle-constants>`;
	};
	const applies = (specimen: S) => source.constants !== false && (source.always === true || isOwn(specimen));
	return [
		{
			name: "basic-constants",
			initial: undefined,
			panel: { group: BASICS, place: "below", draw: (context) => panel("basics", context) },
			applies: (specimen) => applies(specimen) && (source.basics?.(specimen) ?? 0) > 0,
		},
		{
			name: "constants",
			initial: undefined,
			panel: { group: CONSTANTS, place: "below", draw: (context) => panel("others", context) },
			applies,
		},
	];
}

/** Returns the tool that opens the editor of the text. */
function editorTool<S extends Specimen & WithGrammar, G extends Plant>(
	source: GrammarSource<S>,
	stepped: boolean,
): Tool<S, G, GrammarState> {
	const tool: Tool<S, G, GrammarState> = {
		name: "grammar",
		initial: { open: false, indents: false },
		recall: (stored) => ({ open: false, indents: (stored as Partial<GrammarState> | undefined)?.indents === true }),
		press: (context) => (context.toolState(tool).open ? closeEditor(context, tool) : openEditor(context, tool)),
		button: {
			slot: "source",
			icon: GRAMMAR,
			get label() {
				return text("grammar");
			},
			pressed: (context) => context.toolState(tool).open,
		},
		key: {
			letter: "g",
			get description() {
				return text("key_toggle");
			},
		},
		keys: [
			{
				keys: ["Alt ↑", "Alt ↓"],
				get description() {
					return text("key_number");
				},
			},
			{
				keys: ["Ctrl F", "F3"],
				get description() {
					return text("key_find");
				},
			},
			{
				keys: ["Ctrl Space"],
				get description() {
					return text("key_suggest");
				},
			},
			{
				keys: ["Esc"],
				get description() {
					return text("key_leave");
				},
			},
		],
		pane: {
			get title() {
				return text("grammar");
			},
			open: (context) => context.toolState(tool).open,
			report: (context, fault) => reportFault(context, tool, fault),
			draw: (context) => html`<panicle-grammar
				.context=${context} .source=${source} .tool=${tool} .stepped=${stepped} .close=${() => closeEditor(context, tool)}
			></panicle-grammar>`,
		},
	};
	return tool;
}

/** Opens the pane, whose script is loaded now. */
function openEditor<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	tool: Tool<S, G, GrammarState>,
): void {
	context.setToolState(tool, { ...context.toolState(tool), open: true });
	void bring(context, () => import("./grammar_pane"), text("editor_not_loaded"));
}

/**
 * Closes the pane. An error in the text, which only the open pane shows, becomes a notice if an earlier plant is still
 * in view.
 */
function closeEditor<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	tool: Tool<S, G, GrammarState>,
): void {
	context.setToolState(tool, { ...context.toolState(tool), open: false });
	const { fault, grown } = context.state;
	if (fault && fault.line > 0 && grown) reportFault(context, tool, fault);
}

/** Notifies of an error in the grammar, with a button that opens the editor. */
function reportFault<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	tool: Tool<S, G, GrammarState>,
	{ line, column, message }: Fault,
): void {
	const where = text("at_place", { line: String(line), column: String(column), problem: message });
	context.notify(text("not_grown"), [where], {
		topic: GROWTH_TOPIC,
		act: { label: text("edit"), run: () => openEditor(context, tool) },
	});
}

/**
 * Loads a script; if that fails, notifies with a button that tries again.
 * @param failed title of the notice, also its topic
 */
async function bring<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	fetch: () => Promise<unknown>,
	failed: string,
): Promise<void> {
	try {
		await fetch();
	} catch {
		const again = () => void bring(context, fetch, failed);
		context.notify(failed, [text("part_not_loaded")], { topic: failed, again });
	}
}
