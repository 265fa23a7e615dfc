import { html, nothing, type TemplateResult } from "lit";
import { encodeLink } from "../../specimen/link";
import { chooseFile } from "../../ui/choose_file";
import { saveFile } from "../../ui/save_file";
import { notInLink } from "../address";
import { text } from "../messages.generated";
import { text as recentText } from "../recent/messages.generated";
import { openRecent } from "../recent/open_recent";
import { RecentList } from "../recent/recent_list";
import type { RecentPlant } from "../recent/recent_plant";
import { ownRecents } from "../recent/recents";
import type { LibraryStep } from "../saved/library";
import { type Brought, broughtInWords, readLibrary, writeLibrary } from "../saved/library_file";
import { openSaved, savedOf } from "../saved/on_screen";
import { ownLibrary, requestPersistence } from "../saved/own_library";
import { countAndName, LONGEST_NAME, type Saved, tidyName, uniqueName } from "../saved/saved";
import type { Studio } from "../studio";
import { titleOf } from "../title";
import { fetchFailed } from "../types";
import type { SavedList } from "./saved_list";
import { StudioPart } from "./studio_part";
import "./saved_list";
import "../style/saved.css";

/** The dialog's last message, with the lines below it. */
interface DialogMessage {
	readonly text: string;
	readonly lines: readonly string[];
}

/** The longest time that the dialog waits for the recent plants before it opens; milliseconds. */
const LONGEST_WAIT = 100;

const NO_MESSAGE: DialogMessage = { text: "", lines: [] };

/**
 * The dialog of the saved specimens: saves the current one; lists, opens, renames, deletes, exports and imports saved
 * ones.
 */
export class SavedDialog extends StudioPart {
	readonly #library = ownLibrary();
	readonly #recent = new RecentList(ownRecents(), () => {
		this.requestUpdate();
		return this.updateComplete;
	});
	#isOpen = false;
	/** The link of the current specimen, and the parts that the link does not hold. */
	#link = "";
	#lost: readonly string[] = [];
	#name = "";
	/** Whether a specimen is being saved. */
	#busy = false;
	#message = NO_MESSAGE;
	#follow: (() => void) | undefined;

	/** Returns the values whose change redraws the dialog. */
	protected override shows({ state: { specimen, shown } }: Studio): readonly unknown[] {
		return this.#isOpen ? [specimen, shown] : [];
	}

	/** Starts to follow the library. */
	override connectedCallback(): void {
		super.connectedCallback();
		this.#follow = this.#library.subscribe(() => this.requestUpdate());
	}

	/** Stops following the library. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#follow?.();
	}

	/** Renders the dialog, empty while it is closed. */
	protected override draw(studio: Studio): unknown {
		return html`<dialog class="help many saved" aria-labelledby=${this.idOf("title")} @close=${this.#closed} @keydown=${this.#key}>
			<h2 id=${this.idOf("title")}>${text("saved")}</h2>
			${this.#isOpen ? this.#body(studio) : nothing}
		</dialog>`;
	}

	/** Opens the dialog; the browser traps the focus and restores it. */
	async open(): Promise<void> {
		if (this.#isOpen) return;
		const { model, specimen } = this.context.state;
		this.#isOpen = true;
		this.#message = NO_MESSAGE;
		this.#recent.reset();
		const recent = this.#recent.read();
		this.#lost = notInLink(model, specimen);
		this.#link = await encodeLink(model, specimen);
		this.#suggest();
		// Read within a few milliseconds: with them at once, the form below need not move.
		await Promise.race([recent, new Promise((resolve) => setTimeout(resolve, LONGEST_WAIT))]);
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
		this.querySelector<HTMLInputElement>(".save input")?.select();
		const suggested = this.#name;
		await Promise.all([this.#library.read(), recent]);
		if (this.#name === suggested) this.#suggest();
		this.requestUpdate();
	}

	/** Imports the specimens of a library's file, and shows the result. */
	bring(file: string, document: unknown): Promise<void> {
		return this.#take(file, async () => readLibrary(document));
	}

	/** Renders the form that saves, the messages, the list of saved plants, and buttons for files. */
	#body(studio: Studio): TemplateResult {
		const { all, lastStep } = this.#library;
		const twin = all.find(({ link }) => link === this.#link);
		return html`${this.#recentPlants()}
			${this.#form(studio)}
			<div class="said">
				<div role="status">
					<p>${this.#message.text || (twin ? text("saved_already", { name: twin.name }) : nothing)}</p>
					${this.#message.lines.length > 0 ? html`<ul>${this.#message.lines.map((line) => html`<li>${line}</li>`)}</ul>` : nothing}
				</div>
				${
					lastStep
						? html`<button class="button" type="button" title="Ctrl+Z" @click=${this.#undo}>${undoLabel(lastStep)}</button>`
						: nothing
				}
			</div>
			${this.#trouble()}
			${all.length > 0 ? this.#list(studio) : html`<p class="empty">${text("saved_empty")}</p>`}
			<p class="where">${text("saved_where")}</p>
			<div class="choices">
				<button class="button" type="button" ?disabled=${all.length === 0} @click=${() => this.#export(all)}>${text("saved_export")}</button>
				${chooseFile({ accept: ".json,application/json", label: text("saved_import_field"), caption: text("saved_import"), take: (file) => void this.#import(file) })}
				<button class="button quiet" type="button" @click=${this.#close}>${text("close")}</button>
			</div>`;
	}

	/** Renders the recent plants without the one on the controls, which is open already. */
	#recentPlants(): unknown {
		const title = recentText("recent");
		const open = (plant: RecentPlant) => this.#openRecent(plant);
		return this.#recent.draw({ title, element: html`<h3>${title}</h3>` }, open, ({ link }) => link !== this.#link);
	}

	/** Renders the form that saves the current plant, and what the link of the plant does not contain. */
	#form({ state: { shown } }: Studio): TemplateResult {
		return html`<form class="save" @submit=${this.#save}>
				<label>${text("saved_name")} <input
					name="name" required autocomplete="off" maxlength=${LONGEST_NAME} .value=${this.#name}
					@input=${({ target }: Event) => {
						this.#name = (target as HTMLInputElement).value;
					}}
				></label>
				<button class="button wine" ?disabled=${this.#busy || !shown}>${text("saved_save")}</button>
			</form>
			${this.#lost.length > 0 ? html`<p class="lost">${this.#lost.join(" ")}</p>` : nothing}`;
	}

	/** Warns of specimens that could not be stored, with buttons to export them or try again. */
	#trouble(): unknown {
		const { trouble, unstored } = this.#library;
		if (!trouble && unstored.length === 0) return nothing;
		return html`<div class="trouble" role="alert">
			<p>${trouble ?? nothing} ${unstored.length > 0 ? html`<b>${text("saved_unstored", countAndName(unstored))}</b>` : nothing}</p>
			${
				unstored.length > 0
					? html`<button class="button" type="button" @click=${() => this.#export(unstored)}>${text("saved_export_unstored")}</button>
						<button class="button" type="button" @click=${() => this.#library.keep()}>${text("try_again")}</button>`
					: nothing
			}
		</div>`;
	}

	/** Renders the list of saved plants. */
	#list(studio: Studio): TemplateResult {
		return html`<panicle-saved-list
			.context=${studio} .library=${this.#library}
			@open-saved=${({ detail }: CustomEvent<Saved>) => void this.#openOne(detail)}
			@message=${({ detail }: CustomEvent<string>) => this.#showMessage({ text: detail })}
		></panicle-saved-list>`;
	}

	/** Suggests a name for the current plant that no saved one has. */
	#suggest(): void {
		const { specimen, model, modelUi } = this.context.state;
		const names = this.#library.all.map(({ name }) => name);
		this.#name = uniqueName(titleOf(specimen, model, modelUi?.tools), names);
		this.requestUpdate();
	}

	/** Shows a message in place of the last one. */
	#showMessage(message: Partial<DialogMessage>): void {
		this.#message = { ...NO_MESSAGE, ...message };
		this.requestUpdate();
	}

	/** Saves the current plant under the typed name, or its title. */
	async #save(event: SubmitEvent): Promise<void> {
		event.preventDefault();
		if (this.#busy) return;
		this.#busy = true;
		this.#showMessage(NO_MESSAGE);
		try {
			const requestedName = tidyName(this.#name) || titleOf(this.context.state.specimen, this.context.state.model);
			const added = await this.#library.add(await savedOf(this.context, requestedName));
			if (this.#library.isStored(added)) await this.#reportSaved(added, requestedName);
			this.#suggest();
		} catch (error) {
			const problem = error instanceof Error ? error.message : String(error);
			this.#showMessage({ text: text("saved_not_saved", { problem }) });
		} finally {
			this.#busy = false;
			this.requestUpdate();
		}
	}

	/**
	 * Reports under which name a plant was saved, and requests persistent storage.
	 * @param requestedName the typed name, which may have been taken
	 */
	async #reportSaved({ name }: Saved, requestedName: string): Promise<void> {
		const line =
			name === requestedName ? text("saved_as", { name }) : text("saved_as_taken", { name, taken: requestedName });
		this.#showMessage({ text: line });
		await requestPersistence();
	}

	/** Opens a saved plant and closes the dialog; a failure is reported as a notice that tries again. */
	async #openOne(saved: Saved): Promise<void> {
		const opening = openSaved(this.context, saved);
		this.#close();
		try {
			await opening;
		} catch {
			const again = () => void this.#openOne(saved);
			this.context.notify(text("saved_not_opened", { name: saved.name }), fetchFailed(), { again });
		}
	}

	/** Opens a recent plant and closes the dialog. */
	#openRecent(plant: RecentPlant): void {
		void openRecent(this.context, plant);
		this.#close();
	}

	/** Undoes the last step in the list, and moves the focus to a restored plant, since the pressed button disappears. */
	readonly #undo = async (): Promise<void> => {
		const step = await this.#library.undo();
		if (!step) return;
		this.#showMessage({ text: undoneInWords(step) });
		this.#suggest();
		await this.updateComplete;
		const list = this.querySelector<SavedList>("panicle-saved-list");
		await list?.updateComplete;
		if (step.kind === "deletion") await list?.goToFirst(step.specimens.map(({ id }) => id));
		else this.querySelector<HTMLElement>(".choices .button")?.focus();
	};

	/** Saves a file with some saved plants and their pictures. */
	async #export(several: readonly Saved[]): Promise<void> {
		const saved = await this.#library.withPictures(several);
		const now = Date.now();
		saveFile(writeLibrary(saved, now), `saved-${new Date(now).toISOString().slice(0, 10)}.panicle.json`);
	}

	/** Imports the saved plants of a file. */
	#import(file: File): Promise<void> {
		return this.#take(file.name, async () => {
			const reader = await import("../../formats/restore");
			const found = await reader.foundInFile(file.name, file);
			if ("library" in found) return readLibrary(found.library);
			throw new reader.FileError(text.message("saved_import_single", { file: file.name }));
		});
	}

	/**
	 * Adds saved plants that `read` returns to the library, and reports how many and which problems there were.
	 * @param file name for messages
	 */
	async #take(file: string, read: () => Promise<Brought>): Promise<void> {
		try {
			const brought = await read();
			this.#showMessage(broughtInWords(brought, await this.#library.bring(brought.saved)));
			this.#suggest();
		} catch (error) {
			this.#showMessage({
				text: text("saved_import_failed", { file }),
				lines: [error instanceof Error ? error.message : String(error)],
			});
		}
	}

	/** Undoes the library's last step by Ctrl+Z, not the document's; text fields handle the key themselves. */
	#key(event: KeyboardEvent): void {
		if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
		if (event.target instanceof HTMLInputElement && event.target.type !== "checkbox") return;
		event.preventDefault();
		void this.#undo();
	}

	/** Closes the dialog. */
	#close(): void {
		this.querySelector("dialog")?.close();
	}

	/** Empties the dialog after it has been closed. */
	#closed(): void {
		this.#isOpen = false;
		this.requestUpdate();
	}
}

/** Returns the label of the undo button. */
function undoLabel({ kind, specimens }: LibraryStep): string {
	if (kind === "import") return text("saved_undo_import", { count: specimens.length });
	return text("saved_undo_delete", countAndName(specimens));
}

/** Describes the step that was undone. */
function undoneInWords({ kind, specimens }: LibraryStep): string {
	if (kind === "import") return text("saved_undone_import", { count: specimens.length });
	return text("saved_undone_delete", countAndName(specimens));
}

customElements.define("panicle-saved", SavedDialog);
