import { canViewInRoom } from "../files/room";
import type { Studio } from "../studio";
import { hasRoomSession } from "../view/room_support";
import type { DownloadSheet } from "./download_sheet";
import { DOWNLOADS } from "./late_parts";
import { openPart } from "./open_part";

/** Whether the plant can be viewed in the user's room: by Quick Look, or by a session in the page. */
export const offersRoom = ({ state: { shown, view } }: Studio): boolean =>
	shown !== undefined && (canViewInRoom() || (view !== undefined && hasRoomSession()));

/** Shows the plant in the user's room, or the link of the download sheet that does so in Quick Look. */
export function openRoom(studio: Studio): void {
	if (canViewInRoom()) void openPart<DownloadSheet>(studio, DOWNLOADS, (sheet) => sheet.open("room"));
	else studio.toggleAid("room");
}
