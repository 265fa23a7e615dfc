import { html, nothing, svg } from "lit";
import type { Plant } from "../plant/plant";
import type { WithGrammar } from "../specimen/grammar_text";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, Fault } from "../ui/editor_context";
import { GROWTH_TOPIC, type Tool } from "../ui/tool";
import { type DerivationSource, derivationTool } from "./derivation_tool";
import { type GrammarSource, isOwn, withText } from "./source";

/** State of the editor that the page stores. */
export interface GrammarState {
	readonly open: boolean;
	/** Whether Tab indents in the editor. */
	readonly indents: boolean;
}

const GRAMMAR = svg`<path d="M7.5 4 3.5 10l4 6M12.5 4l4 6-4 6"/>`;

const EDIT = "Edit the grammar";

/** Panel group with a slider for each constant of the text. */
const CONSTANTS = {
	key: "constants",
	title: "Constants",
	help: "The numbers and curves that the grammar defines, to be given other values.",
	everyday: true,
} as const;

/**
 * Group for the notice at the panel's end: if handles and gestures write the text, the controls above must not move.
 */
const OWN = {
	key: "own-grammar",
	title: "Grammar",
	help: "The text that this plant grows by.",
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
	const { group = OWN, noun } = source;
	const drop = (context: EditorContext<S, G>) =>
		context.set(withText(source as unknown as GrammarSource, context.state.specimen, undefined));
	const words = "Use the built-in grammar";
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
					<p>This ${noun} brings a grammar of its own.</p>
					<div class="actions">
						<button class="button" type="button" @click=${() => show(context, tool)}>${EDIT}</button>
						<button class="button" type="button" @click=${() => drop(context)}>${words}</button>
					</div>
				</div>`,
		},
		remedies: [
			{ words: EDIT, press: (context) => show(context, tool) },
			{ words, press: drop },
		],
	};
	return [
		tool as Tool<S, G>,
		...(derived ? [derivationTool(derived) as Tool<S, G>] : []),
		{
			name: "constants",
			initial: undefined,
			panel: {
				group: CONSTANTS,
				place: "below",
				draw: (context) => {
					void bring(context, () => import("./constants"), "The grammar's sliders could not be fetched");
					return html`<panicle-constants .context=${context} .source=${source}></panicle-constants>`;
				},
			},
			applies: (specimen) => source.constants !== false && (source.always === true || isOwn(specimen)),
		},
		own as Tool<S, G>,
	];
}

function editorTool<S extends Specimen & WithGrammar, G extends Plant>(
	source: GrammarSource<S>,
	stepped: boolean,
): Tool<S, G, GrammarState> {
	const tool: Tool<S, G, GrammarState> = {
		name: "grammar",
		initial: { open: false, indents: false },
		recall: (stored) => ({ open: false, indents: (stored as Partial<GrammarState> | undefined)?.indents === true }),
		press: (context) => (context.toolState(tool).open ? closeEditor(context, tool, source.noun) : show(context, tool)),
		button: { icon: GRAMMAR, label: "Grammar", pressed: (context) => context.toolState(tool).open },
		key: { letter: "g", does: "The grammar as text, and back" },
		keys: [
			{
				keys: ["Alt ↑", "Alt ↓"],
				does: "In the grammar, at a number: more, less; with Shift ten steps, with Ctrl a tenth",
			},
			{ keys: ["Ctrl F", "F3"], does: "In the grammar: find, and the next one" },
			{ keys: ["Ctrl Space"], does: "In the grammar: what may stand here" },
			{ keys: ["Esc"], does: "In the grammar: out of the text" },
		],
		pane: {
			title: "Grammar",
			open: (context) => context.toolState(tool).open,
			report: (context, fault) => reportFault(context, tool, source.noun, fault),
			draw: (context) => html`<panicle-grammar
				.context=${context} .source=${source} .tool=${tool} .stepped=${stepped} .close=${() => closeEditor(context, tool, source.noun)}
			></panicle-grammar>`,
		},
	};
	return tool;
}

function show<S extends Specimen, G extends Plant>(context: EditorContext<S, G>, tool: Tool<S, G, GrammarState>): void {
	context.setToolState(tool, { ...context.toolState(tool), open: true });
	void bring(context, () => import("./grammar_pane"), "The grammar's editor could not be fetched");
}

/** Closes the pane; a fault that the text no longer shows becomes a notice. */
function closeEditor<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	tool: Tool<S, G, GrammarState>,
	noun: string,
): void {
	context.setToolState(tool, { ...context.toolState(tool), open: false });
	const { fault, grown } = context.state;
	if (fault && fault.line > 0 && grown) reportFault(context, tool, noun, fault);
}

function reportFault<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	tool: Tool<S, G, GrammarState>,
	noun: string,
	{ line, column, message }: Fault,
): void {
	const where = `Line ${line}, column ${column} of the grammar: ${message}`;
	context.notify(`This cannot be grown; the last ${noun} stays`, [where], {
		topic: GROWTH_TOPIC,
		act: { words: EDIT, run: () => show(context, tool) },
	});
}

async function bring<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
	fetch: () => Promise<unknown>,
	failed: string,
): Promise<void> {
	try {
		await fetch();
	} catch {
		const again = () => void bring(context, fetch, failed);
		context.notify(failed, ["Part of the page could not be fetched."], { topic: failed, again });
	}
}
