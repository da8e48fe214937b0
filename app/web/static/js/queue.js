// Queue
import "./page.js";
