// Everything that the page's scripts say to people, by room and with the numbers and names that go into it. What is always on the page
// is in index.html. Errors that only a developer can meet stay where they are thrown.

import { counted } from './format';

// Rooms: base, view, drawing, mesh, files, workshop, opening, export

/** Said where a part of the page or a worker is missing. */
export const LOST = {};

// Rooms: model, controls, plot, details

// Rooms: session, seams, selection, help, and the top room
