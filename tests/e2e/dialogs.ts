/** All dialogs of the studio, for tests that visit each of them. */
import type { Locator } from "@playwright/test";
import { expect } from "./fixtures";
import type { StudioPage } from "./studio_page";

/** A dialog of the studio: how it is opened, and the name that it has then. */
export interface DialogPlace {
	readonly name: string;
	open(studio: StudioPage): Promise<unknown>;
	/** Actions in the dialog before it is checked, which show other parts of it. */
	prepare?(dialog: Locator): Promise<unknown>;
}

/** Unfolds everything that is folded in a dialog. */
const unfold = (dialog: Locator) =>
	dialog.locator("details:not([open]) > summary").evaluateAll((all) => {
		for (const each of all as HTMLElement[]) each.click();
	});

/** All dialogs, by the buttons and keys that open them. */
export const DIALOGS: readonly DialogPlace[] = [
	{ name: "Presets", open: (studio) => studio.browse(), prepare: unfold },
	{
		name: "My plants",
		open: (studio) => studio.button("My plants").click(),
		prepare: async (dialog) => {
			await dialog.getByRole("button", { name: /^Save this/ }).click();
			await expect(dialog.getByRole("status").first()).toContainText("Saved as");
		},
	},
	{ name: "Help", open: (studio) => studio.button("Help").click(), prepare: unfold },
	{ name: "Keyboard shortcuts", open: (studio) => studio.page.keyboard.press("?") },
	{ name: "Share this plant", open: (studio) => studio.openShare(), prepare: unfold },
	{ name: "Download", open: (studio) => studio.openDownloads(), prepare: unfold },
	{
		name: "Copy embed code",
		open: async (studio) => (await studio.openShare()).getByRole("button", { name: "Copy embed code…" }).click(),
	},
	{
		name: "Export batch (ZIP)",
		open: async (studio) => (await studio.openDownloads()).getByRole("button", { name: "Export batch (ZIP)…" }).click(),
	},
	{
		name: "Search everything",
		open: ({ page }) => page.keyboard.press("Control+k"),
		prepare: (dialog) => dialog.getByRole("combobox").fill("a"),
	},
];

/** Opens a dialog, and shows all of its parts. @returns the dialog */
export async function openDialog(studio: StudioPage, { name, open, prepare }: DialogPlace): Promise<Locator> {
	await open(studio);
	const dialog = studio.page.getByRole("dialog", { name, exact: true });
	await expect(dialog).toBeVisible();
	await prepare?.(dialog);
	return dialog;
}
