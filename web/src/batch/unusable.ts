/** A text about a series that cannot be used. The message is one plain sentence with a remedy. */
export class Unusable extends Error {
	override name = "Unusable";
}
