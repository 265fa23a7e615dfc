/** Support for viewing a plant in the user's room by WebXR. */

let supported = false;

/** Whether the browser offers augmented reality in the page; false until `findRoomSupport` has resolved. */
export const hasRoomSession = (): boolean => supported;

/** Finds out whether the browser offers augmented reality in the page. */
export async function findRoomSupport(): Promise<void> {
	supported = (await navigator.xr?.isSessionSupported("immersive-ar").catch(() => false)) ?? false;
}
