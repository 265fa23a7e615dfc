/** The worker that paints leaves. */
import { moved, type PaintedLeaf, Painter, type PaintOrder } from "./paint";

/** The part of a worker's global scope that this file uses; the page's types do not describe it. */
interface Scope {
	postMessage(message: PaintedLeaf, transfer: Transferable[]): void;
	onmessage: ((event: MessageEvent<PaintOrder>) => void) | null;
}

const scope = globalThis as unknown as Scope;
const painter = new Painter();
scope.onmessage = ({ data }) => {
	const faces = painter.paint(data);
	scope.postMessage({ ...faces, id: data.id }, moved(faces));
};
