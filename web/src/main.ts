import { emptyScene, initialState } from "./model/initial";
import { createStore } from "./store";

const store = createStore(initialState(emptyScene("room-1"), Date.now()));
console.info(store.getState().scene.name);
