import { MessageError } from "../locale/message_error";

/** A text about a series that cannot be used. */
export class Unusable extends MessageError {
	override name = "Unusable";
}
