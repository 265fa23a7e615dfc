/** Entry point of the gestures' script, loaded on first use. */
import "./gesture_bar";

export { GestureInteraction } from "./gesture_interaction";
