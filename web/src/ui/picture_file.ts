/** Picture files from the user. */

/** For a file input's `accept`. */
export const PICTURES = "image/png,image/jpeg,image/webp";

/** File names, for systems that do not know the type. */
const NAMES = /\.(png|jpe?g|webp)$/i;

/** Returns whether a file is a picture, by its type or its name. */
export const isPicture = ({ name, type }: Pick<File, "name" | "type">): boolean =>
	type.startsWith("image/") || NAMES.test(name);
