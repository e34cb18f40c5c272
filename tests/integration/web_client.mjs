// A client of somebody else's making: Node's own WebSocket. Plays a stream and prints its packets.
//   node --experimental-websocket web_client.mjs URL

const socket = new WebSocket(process.argv[2]);
let bytes = "";
socket.onopen = () => socket.send("{hello v=2 window=2}");
socket.onmessage = ({ data }) => {
  bytes += data;
  for (let end; (end = bytes.indexOf("}") + 1) > 0; bytes = bytes.slice(end)) {
    const packet = bytes.slice(0, end);
    console.log(packet);
    if (/^\{[~0-9LR]/.test(packet)) socket.send("1");
  }
};
socket.onclose = ({ code, wasClean }) => console.log(`closed ${code}${wasClean ? "" : " badly"}`);
