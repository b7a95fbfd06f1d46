// Reads a recording with the official MCAP library and prints its rows of numbers as JSON:
// node read.mjs FILE.mcap
// Nothing here knows searig's code: rows are decoded from the schemas that the file itself holds.
import { readFileSync } from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";

const file = readFileSync(process.argv[2]);

/** Plain little-endian CDR of fields that are all float64: an array for each message. */
function decodeRow(schema, data) {
  const fields = schema.trim().split("\n");
  const view = new DataView(data.buffer, data.byteOffset + 4, data.byteLength - 4);
  if (view.byteLength !== 8 * fields.length) throw new Error("a message is no such row");
  return fields.map((_, i) => view.getFloat64(8 * i, true));
}

/** By the index at the end, as Foxglove and PlotJuggler open a file. */
async function readIndexed() {
  const readable = {
    size: async () => BigInt(file.length),
    read: async (offset, size) => file.subarray(Number(offset), Number(offset + size)),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  const topics = {};
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = new TextDecoder().decode(reader.schemasById.get(channel.schemaId).data);
    const topic = (topics[channel.topic] ??= { schema, messages: 0, rows: [] });
    topic.messages += 1;
    if (/^(float64 \w+\n)+$/.test(schema)) topic.rows.push(decodeRow(schema, message.data));
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
