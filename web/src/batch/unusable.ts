/** What was typed of a series cannot be used. The message is one plain sentence with what to write instead. */
export class Unusable extends Error {
	override name = "Unusable";
}
