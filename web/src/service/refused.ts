/** A request that is not answered with a plant: the reason in one line, and the HTTP status. */
export class Refused extends Error {
	override name = "Refused";
	constructor(
		readonly status: 400 | 404 | 405 | 413 | 414 | 422 | 500 | 501 | 503,
		message: string,
		readonly headers: Readonly<Record<string, string>> = {},
	) {
		super(message);
	}
}
