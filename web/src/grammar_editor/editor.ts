/**
 * Text editor for a grammar: CodeMirror in a shadow tree of its own, where its style sheets satisfy the page's content
 * security policy. The editor has no undo history, because its steps are the document's.
 */
import {
	autocompletion,
	closeBrackets,
	closeBracketsKeymap,
	completionKeymap,
	completionStatus,
} from "@codemirror/autocomplete";
import { defaultKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { Annotation, Compartment, EditorState, Prec, Transaction } from "@codemirror/state";
import { drawSelection, EditorView, type KeyBinding, keymap, lineNumbers, type ViewUpdate } from "@codemirror/view";
import { completion } from "./completion";
import { type Dialect, dialect } from "./dialect";
import { difference } from "./difference";
import { EDITOR_STYLE } from "./editor_style";
import { type Explanation, explain, productionAt } from "./explain";
import { closeFind, finding, openFind } from "./find";
import { highlight, outlined } from "./highlight";
import { NumberDrag, numberHere, scrubbing, stepHere } from "./numbers";
import type { NumberAt } from "./outline";
import { placeOf, setProblems, showProblems } from "./problems";
import { type MarkedProductions, markProductions, productionMarks } from "./production_marks";
import { type Problem, sameProblems } from "./reported_problems";
import { typingOver } from "./typing_over";

/** Events of the editor. */
export interface EditorEvents {
	/**
	 * The user changed the text.
	 * @param how kind and place of the change: equal values form one undo step
	 */
	edited(text: string, how: string): void;
	/** Ends the current undo step, before and after a drag. */
	settle(): void;
	undo(): void;
	redo(): void;
	/** Escape: moves the focus out of the editor. */
	leave(): void;
	/**
	 * The cursor moved, or the text at it changed.
	 * @param production line of the production at the cursor
	 */
	at(number: NumberAt | undefined, explained: Explanation | undefined, production: number | undefined): void;
	/** The editor lost the focus. */
	blurred(): void;
}

export interface EditorOptions {
	readonly text: string;
	/** Accessible name of the editor, and description of its keys. */
	readonly label: string;
	readonly help: string;
	/** Names that `#role` takes. */
	readonly roles: readonly string[];
	/** Whether Tab indents; else Tab moves the focus to the next element. */
	readonly indents: boolean;
	/** Language of the text; defaults to L-systems. */
	readonly dialect?: Dialect | undefined;
}

/** Marks a change that came from the document and not from the user. */
const fromDocument = Annotation.define<boolean>();

export class Editor {
	readonly #view: EditorView;
	readonly #events: EditorEvents;
	readonly #tab = new Compartment();
	#indents: boolean;
	/**
	 * Problems currently marked. Setting equal problems again would redo the layout of the whole text, so it is skipped.
	 */
	#shownProblems: readonly Problem[] | undefined;
	/** Kind and place of the last edit; an edit that does not continue it begins an undo step. */
	#how = "";
	#end = -1;
	#turn = 0;

	/**
	 * @param root shadow root that receives the editor and its style
	 * @param options.indents whether Tab indents, instead of moving the focus
	 */
	constructor(
		root: ShadowRoot,
		{ text, label, help, roles, indents, dialect: language }: EditorOptions,
		events: EditorEvents,
	) {
		this.#events = events;
		this.#indents = indents;
		const described = document.createElement("p");
		described.id = "keys";
		described.hidden = true;
		described.textContent = help;
		root.append(described);
		this.#view = new EditorView({
			root,
			parent: root,
			state: EditorState.create({
				doc: text,
				extensions: [
					this.#keys(),
					this.#tab.of(tab(indents)),
					lineNumbers(),
					drawSelection(matchMedia("(prefers-reduced-motion: reduce)").matches ? { cursorBlinkRate: 0 } : {}),
					bracketMatching(),
					closeBrackets(),
					autocompletion({ override: [completion(roles)], icons: false }),
					...(language ? [dialect.of(language)] : []),
					highlight,
					showProblems,
					productionMarks,
					finding(),
					typingOver,
					scrubbing({ begin: () => events.settle(), end: () => events.settle() }),
					EditorView.lineWrapping,
					EditorView.contentAttributes.of({
						"aria-label": label,
						"aria-describedby": described.id,
						autocapitalize: "off",
						spellcheck: "false",
						autocorrect: "off",
						// Editable text can be focused without it, but accessibility checkers do not count it.
						tabindex: "0",
					}),
					EditorView.updateListener.of((update) => this.#updated(update)),
					EditorView.domEventHandlers({
						blur: () => events.blurred(),
						// Undo and redo from a menu, a shake gesture or a phone's keyboard.
						beforeinput: (event) => {
							const act = { historyUndo: events.undo, historyRedo: events.redo }[event.inputType];
							if (act) event.preventDefault();
							act?.();
							return act !== undefined;
						},
					}),
					EDITOR_STYLE,
				],
			}),
		});
	}

	/** The whole text, with \n as line end. */
	get text(): string {
		return this.#view.state.doc.toString();
	}

	/** Replaces the text, changing only the part that differs. */
	set text(next: string) {
		const change = difference(this.text, next);
		if (!change) return;
		const anchor = change.from + change.insert.length;
		this.#view.dispatch({
			changes: change,
			// Scrolls to the undone change if the editor has the focus.
			...(this.#view.hasFocus ? { selection: { anchor }, scrollIntoView: true } : {}),
			annotations: [fromDocument.of(true), Transaction.addToHistory.of(false)],
		});
	}

	/** Marks problems in the text, in place of the last ones. */
	set problems(problems: readonly Problem[]) {
		if (this.#shownProblems && sameProblems(this.#shownProblems, problems)) return;
		this.#shownProblems = problems;
		setProblems(this.#view, problems);
		// The list of problems below the text may cover the current line.
		if (problems.length > 0) requestAnimationFrame(() => this.showCursor());
		this.#view.contentDOM.ariaInvalid = String(problems.some(({ severity }) => severity === "error"));
	}

	/** Marks productions and scrolls to them. */
	set productions(productions: MarkedProductions) {
		markProductions(this.#view, productions);
	}

	/** Sets whether Tab indents, instead of moving the focus. */
	set indents(indents: boolean) {
		if (indents === this.#indents) return;
		this.#indents = indents;
		this.#view.dispatch({ effects: this.#tab.reconfigure(tab(indents)) });
	}

	/** Moves the focus into the text. */
	focus(): void {
		this.#view.focus();
	}

	/** Scrolls the current line into view, as little as possible. */
	showCursor(): void {
		const { head } = this.#view.state.selection.main;
		if (this.#view.hasFocus) this.#view.dispatch({ effects: EditorView.scrollIntoView(head, { yMargin: 24 }) });
	}

	/** Opens the search. */
	find(): void {
		openFind(this.#view);
	}

	/** Moves the cursor to a position, such as that of a problem. */
	goTo(place: Pick<Problem, "line" | "column">): void {
		this.select(placeOf(this.#view, place));
	}

	/** Moves the cursor to the beginning of a line, counted from 1. */
	goToLine(line: number): void {
		const { doc } = this.#view.state;
		this.select(doc.line(Math.min(Math.max(line, 1), doc.lines)));
	}

	/** Selects a part of the text and scrolls to it. */
	select({ from, to }: { readonly from: number; readonly to: number }): void {
		this.#view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
		this.#view.focus();
	}

	/** Changes the number at the cursor by a number of steps. */
	step(steps: number): void {
		stepHere(this.#view, steps);
	}

	/**
	 * Begins a drag of the number at the cursor, by any pointer.
	 * @returns function that moves the number by pixels; undefined if there is no number
	 */
	grip(): ((pixels: number, keys: Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">) => void) | undefined {
		const number = numberHere(this.#view);
		if (!number) return undefined;
		const drag = new NumberDrag(number);
		return (pixels, keys) => drag.move(this.#view, pixels, keys);
	}

	/** Removes the editor from the page. */
	destroy(): void {
		this.#view.destroy();
	}

	/** Returns the key bindings of the document, which precede those of CodeMirror. */
	#keys() {
		const { undo, redo, leave } = this.#events;
		const done = (act: () => void) => () => {
			act();
			return true;
		};
		const own: KeyBinding[] = [
			{ key: "Mod-z", run: done(undo), preventDefault: true },
			{ key: "Mod-y", run: done(redo), preventDefault: true },
			{ key: "Mod-Shift-z", run: done(redo), preventDefault: true },
			{
				key: "Escape",
				// The first press closes the list of completions, the second the search.
				run: (view) => {
					if (completionStatus(view.state) !== null) return false;
					if (!closeFind(view)) leave();
					return true;
				},
			},
		];
		return [Prec.high(keymap.of(own)), keymap.of([...closeBracketsKeymap, ...completionKeymap, ...defaultKeymap])];
	}

	/**
	 * Reports edits of the user, and after each change the number, explanation and production at the cursor. Texts that
	 * the document set are not reported.
	 */
	#updated(update: ViewUpdate): void {
		const { docChanged, selectionSet, state, view } = update;
		if (docChanged) this.#shownProblems = undefined;
		const byHand = docChanged && !update.transactions.every((each) => each.annotation(fromDocument));
		if (byHand) this.#events.edited(state.doc.toString(), this.#kindOf(update));
		if (!docChanged && !selectionSet) return;
		const { head } = state.selection.main;
		const outline = state.field(outlined);
		const production = productionAt(outline.pieces, head, state.doc.lineAt(head).number);
		this.#events.at(numberHere(view), explain(outline, head, view.state.facet(dialect).words), production);
	}

	/**
	 * Returns the kind of a change with a number: equal for changes of one undo step. Typing and deleting that continue
	 * at the same place have the same number; a line break begins a new one.
	 */
	#kindOf({ changes, transactions }: ViewUpdate): string {
		const event = transactions.map((each) => each.annotation(Transaction.userEvent)).find(Boolean) ?? "other";
		let [from, end, whole] = [0, 0, ""];
		changes.iterChanges((start, _, __, stop, inserted) => {
			from = start;
			end = stop;
			whole = inserted.toString();
		});
		const goesOn = /^(?:input\.type|delete)/.test(event) && this.#end >= 0 && Math.abs(from - this.#end) <= 1;
		if (event !== this.#how || !(goesOn || event === "input.step") || whole.includes("\n")) this.#turn++;
		this.#how = event;
		this.#end = end;
		return `${event} ${this.#turn}`;
	}
}

/** Returns the key binding of Tab; none if Tab moves the focus. */
function tab(indents: boolean) {
	return indents ? keymap.of([indentWithTab]) : [];
}
