/** Viewing a plant in the user's room: on iPhone, iPad and Vision Pro, Quick Look opens links to USDZ files. */

/** Whether the browser opens links with `rel="ar"` in Quick Look. */
export const canViewInRoom = (): boolean => document.createElement("a").relList.supports("ar");

/** The address of a file in this page, valid until another file replaces it. */
export class FileAddress {
	#file: Blob | undefined;
	#address = "";

	/** Returns the address of a file; that of the last file becomes invalid. */
	of(file: Blob): string {
		if (file === this.#file) return this.#address;
		this.release();
		this.#file = file;
		this.#address = URL.createObjectURL(file);
		return this.#address;
	}

	release(): void {
		if (this.#file) URL.revokeObjectURL(this.#address);
		this.#file = undefined;
	}
}
