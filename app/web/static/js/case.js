// Case
import "./page.js";
