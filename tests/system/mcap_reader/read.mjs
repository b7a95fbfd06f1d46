// Reads a recording with the official MCAP library, decodes its messages with Foxglove's own decoder
// and prints them as JSON: node read.mjs FILE.mcap
// Nothing here knows searig's code: messages are decoded by the schemas that the file itself holds.
import { readFileSync } from "node:fs";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";

const file = readFileSync(process.argv[2]);

/** By the index at the end, as Foxglove and PlotJuggler open a file. */
async function readIndexed() {
  const readable = {
    size: async () => BigInt(file.length),
    read: async (offset, size) => file.subarray(Number(offset), Number(offset + size)),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  const decoders = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = new TextDecoder().decode(reader.schemasById.get(channel.schemaId).data);
    decoders.set(channel.id, new MessageReader(parse(schema, { ros2: true })));
  }
  const topics = {};
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const topic = (topics[reader.channelsById.get(message.channelId).topic] ??= { rows: [] });
    const values = Object.values(decoders.get(message.channelId).readMessage(message.data));
    topic.rows.push(values.map((value) => (value instanceof Uint8Array ? [...value] : value)));
  }
  const attachments = {};
  for await (const attachment of reader.readAttachments())
    attachments[attachment.name] = attachment.data.length;
  return { topics, attachments, statistics: Number(reader.statistics.messageCount) };
}

/** From beginning to end, record by record, every CRC checked. */
function countStreamed() {
  const reader = new McapStreamReader({ validateCrcs: true });
  reader.append(file);
  const counts = {};
  for (let record; (record = reader.nextRecord()); ) {
    counts[record.type] = (counts[record.type] ?? 0) + 1;
  }
  if (!reader.done()) throw new Error("the file does not end");
  return counts;
}

console.log(JSON.stringify({ ...(await readIndexed()), streamed: countStreamed() }));
