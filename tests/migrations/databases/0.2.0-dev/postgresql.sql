--
-- PostgreSQL database dump
--

\restrict arqrpe4dpw5mYIqIcGOKRGZwXvTDnXdLDKB2xwH9k5dB8AiehWpuXtAMONyui6E

-- Dumped from database version 18.6
-- Dumped by pg_dump version 18.6

SET statement_timeout = 0;
SET lock_timeout = 0;
SET idle_in_transaction_session_timeout = 0;
SET transaction_timeout = 0;
SET client_encoding = 'UTF8';
SET standard_conforming_strings = on;
SELECT pg_catalog.set_config('search_path', '', false);
SET check_function_bodies = false;
SET xmloption = content;
SET client_min_messages = warning;
SET row_security = off;

SET default_tablespace = '';

SET default_table_access_method = heap;

--
-- Name: alembic_version; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.alembic_version (
    version_num character varying(32) NOT NULL
);


--
-- Name: api_key; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.api_key (
    id bigint NOT NULL,
    name character varying NOT NULL,
    scope character varying(16) NOT NULL,
    hash character varying(64) NOT NULL,
    max_queued_cases integer,
    cpu_s_per_day double precision,
    created_at double precision NOT NULL,
    revoked_at double precision,
    last_used_at double precision
);


--
-- Name: api_key_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.api_key_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: api_key_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.api_key_id_seq OWNED BY public.api_key.id;


--
-- Name: case; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public."case" (
    id bigint NOT NULL,
    digest character varying(64) NOT NULL,
    solver_version character varying NOT NULL,
    operator_key character varying(64) NOT NULL,
    inputs json NOT NULL,
    speed_kmh double precision NOT NULL,
    slab character varying NOT NULL,
    irregularity character varying NOT NULL,
    spectrum character varying,
    percentile double precision,
    wavelength_min_m double precision,
    wavelength_max_m double precision,
    seed bigint,
    realisation integer,
    wavelength_m double precision,
    amplitude_mm double precision,
    state character varying(16) NOT NULL,
    priority integer NOT NULL,
    attempt integer NOT NULL,
    lease_token character varying(32),
    lease_expires double precision,
    heartbeat_at double precision,
    worker character varying,
    progress double precision NOT NULL,
    error json,
    cpu_s double precision,
    created_at double precision NOT NULL,
    started_at double precision,
    finished_at double precision,
    processing json,
    turn bigint DEFAULT '0'::bigint NOT NULL,
    work double precision,
    charged_to bigint,
    CONSTRAINT ck_case_state CHECK (((state)::text = ANY ((ARRAY['queued'::character varying, 'running'::character varying, 'succeeded'::character varying, 'failed'::character varying, 'cancelled'::character varying])::text[])))
);


--
-- Name: case_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.case_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: case_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.case_id_seq OWNED BY public."case".id;


--
-- Name: event; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.event (
    id bigint NOT NULL,
    study_id character varying(32) NOT NULL,
    kind character varying(16) NOT NULL,
    payload json NOT NULL,
    created_at double precision NOT NULL
);


--
-- Name: event_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.event_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: event_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.event_id_seq OWNED BY public.event.id;


--
-- Name: history; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.history (
    case_id bigint NOT NULL,
    key character varying NOT NULL,
    digest character varying(64) NOT NULL,
    size_bytes bigint NOT NULL
);


--
-- Name: idempotency_key; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.idempotency_key (
    key character varying(255) NOT NULL,
    request_digest character varying(64) NOT NULL,
    response json NOT NULL,
    created_at double precision NOT NULL
);


--
-- Name: peak; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.peak (
    id bigint NOT NULL,
    case_id bigint NOT NULL,
    quantity character varying NOT NULL,
    "position" character varying NOT NULL,
    unit character varying NOT NULL,
    peak double precision NOT NULL,
    maximum double precision NOT NULL,
    minimum double precision NOT NULL,
    mean double precision NOT NULL,
    std double precision NOT NULL,
    rms double precision NOT NULL,
    time_s double precision NOT NULL,
    track_position_m double precision NOT NULL,
    speed_kmh double precision NOT NULL,
    percentile double precision
);


--
-- Name: peak_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.peak_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: peak_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.peak_id_seq OWNED BY public.peak.id;


--
-- Name: profile; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.profile (
    id character varying(64) NOT NULL,
    samples bytea NOT NULL,
    points integer NOT NULL,
    start_m double precision NOT NULL,
    end_m double precision NOT NULL,
    wavelength_min_m double precision NOT NULL,
    wavelength_max_m double precision NOT NULL,
    lowest_mm double precision NOT NULL,
    highest_mm double precision NOT NULL,
    created_at double precision NOT NULL
);


--
-- Name: profile_key; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.profile_key (
    profile_id character varying(64) NOT NULL,
    key_id bigint NOT NULL
);


--
-- Name: study; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study (
    id character varying(32) NOT NULL,
    name character varying NOT NULL,
    labels json NOT NULL,
    priority integer NOT NULL,
    keep_history boolean NOT NULL,
    request json NOT NULL,
    cases_reused integer NOT NULL,
    created_at double precision NOT NULL,
    started_at double precision,
    finished_at double precision,
    cancel_requested_at double precision,
    owner_id bigint,
    end_turn bigint DEFAULT '0'::bigint NOT NULL
);


--
-- Name: study_case; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study_case (
    study_id character varying(32) NOT NULL,
    case_id bigint NOT NULL,
    "position" integer NOT NULL
);


--
-- Name: study_profile; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study_profile (
    study_id character varying(32) NOT NULL,
    profile_id character varying(64) NOT NULL
);


--
-- Name: study_share; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study_share (
    study_id character varying(32) NOT NULL,
    key_id bigint NOT NULL
);


--
-- Name: verification; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.verification (
    id bigint NOT NULL,
    case_id bigint NOT NULL,
    state character varying(16) NOT NULL,
    attempt integer NOT NULL,
    lease_token character varying(32),
    lease_expires double precision,
    requested_at double precision NOT NULL,
    finished_at double precision,
    solver_version character varying,
    outcome character varying(16),
    differences json,
    error json
);


--
-- Name: verification_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.verification_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: verification_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.verification_id_seq OWNED BY public.verification.id;


--
-- Name: worker; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.worker (
    name character varying NOT NULL,
    expires double precision NOT NULL
);


--
-- Name: api_key id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.api_key ALTER COLUMN id SET DEFAULT nextval('public.api_key_id_seq'::regclass);


--
-- Name: case id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case" ALTER COLUMN id SET DEFAULT nextval('public.case_id_seq'::regclass);


--
-- Name: event id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event ALTER COLUMN id SET DEFAULT nextval('public.event_id_seq'::regclass);


--
-- Name: peak id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak ALTER COLUMN id SET DEFAULT nextval('public.peak_id_seq'::regclass);


--
-- Name: verification id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.verification ALTER COLUMN id SET DEFAULT nextval('public.verification_id_seq'::regclass);


--
-- Data for Name: alembic_version; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.alembic_version VALUES ('0007');


--
-- Data for Name: api_key; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.api_key VALUES (1, 'anna', 'write', '1ec7d02b97626bdb0e436bcdf03466cf00a7b529c724095601d6b9aaab21fcfc', NULL, NULL, 1795341509.289, NULL, NULL);


--
-- Data for Name: case; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public."case" VALUES (1, '3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72', '3', 'd3461839b0349939ceb9d50ba75bfb95fd8723a21ec11e200b8c624f852b4e11', '{"speed": 83.33333333333333, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}', 300, 'continuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'succeeded', 0, 1, NULL, NULL, 1795341502.651, 'host:28673', 1, NULL, 0.29196480700000116, 1795341487.472, 1795341502.651, 1795341503.071, '{"sampling_step_s": 0.0001, "samples": 2000, "window_s": 0.2, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.05}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19990000000000002}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.2, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}', 0, 16560000, NULL);
INSERT INTO public."case" VALUES (3, 'afff6f7819ded79cd33ca12e051208c5d1279656ee963780a87553aaa05fcf9c', '3', 'b305072880b3d13a013ac469bc43a37099d217fb92ba67616a02cb34d8b13063', '{"speed": 69.44444444444444, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "spectrum", "wavelength_min": 2.0, "wavelength_max": 30.0, "spectrum": "tb3352-ballastless", "percentile": 25.0, "seed": 7, "realisation": 0}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}', 250, 'continuous', 'spectrum', 'tb3352-ballastless', 25, 2, 30, 7, 0, NULL, NULL, 'succeeded', 0, 1, NULL, NULL, 1795341504.417, 'host:28673', 1, NULL, 0.3595036570000012, 1795341504.355, 1795341504.417, 1795341504.954, '{"sampling_step_s": 9.95744680851064e-05, "samples": 2009, "window_s": 0.20004510638297873, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.04998638297872341}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19994553191489364}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.20004510638297873, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}', 2, 16630769.230769228, NULL);
INSERT INTO public."case" VALUES (4, '94ce1e2b09deba1d94d6c029d116d6608377d5376009eccde29c7420a8d15c85', '3', 'b305072880b3d13a013ac469bc43a37099d217fb92ba67616a02cb34d8b13063', '{"speed": 69.44444444444444, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "measured", "wavelength_min": 0.5, "wavelength_max": 24.75, "profile": "93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e"}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}', 250, 'continuous', 'measured', NULL, NULL, 0.5, 24.75, NULL, NULL, NULL, NULL, 'succeeded', 0, 1, NULL, NULL, 1795341505.166, 'host:28673', 1, NULL, 0.4078824559999994, 1795341505.092, 1795341505.166, 1795341505.764, '{"sampling_step_s": 9.95744680851064e-05, "samples": 2009, "window_s": 0.20004510638297873, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.04998638297872341}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19994553191489364}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.20004510638297873, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}', 3, 16630769.230769228, NULL);
INSERT INTO public."case" VALUES (2, 'a70bd0855c2e1144d06783926e33eab0e3d31ea8e4b2d741569e56f050dea0ce', '3', '929dfa39852d5f6aaa343b3703d8d7b46b4afc39b38315eb1fd72ad06028f6a0', '{"speed": 83.33333333333333, "slab": "discontinuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}', 300, 'discontinuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'succeeded', 0, 1, NULL, NULL, 1795341503.985, 'host:28673', 1, NULL, 0.7973460639999992, 1795341487.473, 1795341503.102, 1795341504.242, '{"sampling_step_s": 0.0001, "samples": 2000, "window_s": 0.2, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.05}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19990000000000002}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.2, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}', 1, 16560000, NULL);
INSERT INTO public."case" VALUES (5, '1b89d0e3a99e55271ac21a6824c6feedd2309d4f04181c1573c0f71d7c3e061f', '3', 'bdc32dade9311c56698e03ba47da24c62dacd165ebe46b4a547d2f69b58f1a7f', '{"speed": 55.55555555555556, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}', 200, 'continuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'queued', 0, 0, NULL, NULL, NULL, NULL, 0, NULL, NULL, 1795341522.619, NULL, NULL, NULL, 4, 16560000, NULL);


--
-- Data for Name: event; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.event VALUES (1, '87568cc732624410b206cd113bf99701', 'state', '{"state": "queued"}', 1795341487.478);
INSERT INTO public.event VALUES (2, '87568cc732624410b206cd113bf99701', 'state', '{"state": "running"}', 1795341502.666);
INSERT INTO public.event VALUES (3, '87568cc732624410b206cd113bf99701', 'case', '{"case_id": 1, "state": "succeeded"}', 1795341503.09);
INSERT INTO public.event VALUES (4, '87568cc732624410b206cd113bf99701', 'case', '{"case_id": 2, "state": "succeeded"}', 1795341504.27);
INSERT INTO public.event VALUES (5, '87568cc732624410b206cd113bf99701', 'state', '{"state": "succeeded"}', 1795341504.301);
INSERT INTO public.event VALUES (6, '87568cc732624410b206cd113bf99701', 'done', '{"state": "succeeded"}', 1795341504.302);
INSERT INTO public.event VALUES (7, 'f4c8e8b7f35f45bba99d5f0663c5087c', 'state', '{"state": "queued"}', 1795341504.357);
INSERT INTO public.event VALUES (8, 'f4c8e8b7f35f45bba99d5f0663c5087c', 'state', '{"state": "running"}', 1795341504.42);
INSERT INTO public.event VALUES (9, 'f4c8e8b7f35f45bba99d5f0663c5087c', 'case', '{"case_id": 3, "state": "succeeded"}', 1795341504.971);
INSERT INTO public.event VALUES (10, 'f4c8e8b7f35f45bba99d5f0663c5087c', 'state', '{"state": "succeeded"}', 1795341504.982);
INSERT INTO public.event VALUES (11, 'f4c8e8b7f35f45bba99d5f0663c5087c', 'done', '{"state": "succeeded"}', 1795341504.983);
INSERT INTO public.event VALUES (12, '6d8d7a9f3d424ebabf92bce3ff15eebf', 'state', '{"state": "queued"}', 1795341505.095);
INSERT INTO public.event VALUES (13, '6d8d7a9f3d424ebabf92bce3ff15eebf', 'state', '{"state": "running"}', 1795341505.171);
INSERT INTO public.event VALUES (14, '6d8d7a9f3d424ebabf92bce3ff15eebf', 'case', '{"case_id": 4, "state": "succeeded"}', 1795341505.784);
INSERT INTO public.event VALUES (15, '6d8d7a9f3d424ebabf92bce3ff15eebf', 'state', '{"state": "succeeded"}', 1795341505.796);
INSERT INTO public.event VALUES (16, '6d8d7a9f3d424ebabf92bce3ff15eebf', 'done', '{"state": "succeeded"}', 1795341505.797);
INSERT INTO public.event VALUES (17, '745c5b76afd5485b8a6a25d79689dc45', 'state', '{"state": "queued"}', 1795341522.627);


--
-- Data for Name: history; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.history VALUES (1, '3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72/1-d8cb01d709db47eabe5b56c606e9e678.npz', '45f291ea22ea617f1461df007d40f9752db923824d63ee36eb27829bd982fd5f', 172284);
INSERT INTO public.history VALUES (2, 'a70bd0855c2e1144d06783926e33eab0e3d31ea8e4b2d741569e56f050dea0ce/1-63e36fbccfe14d9089f75cac84b5c3a9.npz', 'b5c7131e86e0ed4b0f31f479a93f5aee87a5402e5500a2992bbe8318e8871d2f', 202794);


--
-- Data for Name: idempotency_key; Type: TABLE DATA; Schema: public; Owner: -
--



--
-- Data for Name: peak; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.peak VALUES (1, 1, 'wheel_rail_force', 'wheelset_1', 'N', 111479.41651687551, 111479.41651687551, 26532.205424563916, 68496.52299256582, 29706.44759135275, 74660.87791185478, 0.12760000000000002, 35.63333333333333, 300, NULL);
INSERT INTO public.peak VALUES (2, 1, 'wheel_rail_force', 'wheelset_2', 'N', 109950.24011103869, 109950.24011103869, 28167.052480752613, 68841.49457482282, 28607.89480024078, 74549.06451590793, 0.025500000000000002, 27.125, 300, NULL);
INSERT INTO public.peak VALUES (3, 1, 'wheel_rail_force', 'wheelset_3', 'N', 103982.31463611891, 103982.31463611891, 33963.52954953277, 68351.99835408783, 24351.256117426336, 72560.17746321819, 0.1799, 39.99166666666667, 300, NULL);
INSERT INTO public.peak VALUES (4, 1, 'wheel_rail_force', 'wheelset_4', 'N', 101782.02779910644, 101782.02779910644, 36165.843305308335, 68937.46919422352, 22839.392560419554, 72622.39676183557, 0.078, 31.5, 300, NULL);
INSERT INTO public.peak VALUES (5, 1, 'rail_displacement', 'wheelset_1', 'm', 0.0013610145615438312, 0.0013610145615438312, 0.0006165095132885535, 0.0009832675911684429, 0.0002618534446854056, 0.0010175374107794784, 0.0806, 31.716666666666665, 300, NULL);
INSERT INTO public.peak VALUES (6, 1, 'rail_acceleration', 'wheelset_1', 'm/s^2', 131.85648151314953, 98.53717777894127, -131.85648151314953, -12.759292161181012, 79.32966611985044, 80.34920947427749, 0.1285, 35.708333333333336, 300, NULL);
INSERT INTO public.peak VALUES (7, 1, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 103.79887757055005, 101.49228265276437, -103.79887757055005, 1.2154343742195295, 71.8424441008485, 71.85272475767063, 0.1285, 35.708333333333336, 300, NULL);
INSERT INTO public.peak VALUES (8, 1, 'slab_displacement', 'wheelset_1', 'm', 0.00048441891187531416, 0.00048441891187531416, 0.0003918455034688269, 0.00043828645024703965, 3.212364860931676e-05, 0.00043946210447560276, 0.132, 36, 300, NULL);
INSERT INTO public.peak VALUES (9, 1, 'slab_acceleration', 'wheelset_1', 'm/s^2', 13.959275191806942, 12.406700628825334, -13.959275191806942, -0.691644231153423, 9.067855480762653, 9.094194563702994, 0.048100000000000004, 29.008333333333333, 300, NULL);
INSERT INTO public.peak VALUES (10, 1, 'base_displacement', 'wheelset_1', 'm', 0.0004641625651719421, 0.0004641625651719421, 0.0003410765518721964, 0.0004022495254755717, 4.326257959368185e-05, 0.0004045693161108765, 0.1086, 34.05, 300, NULL);
INSERT INTO public.peak VALUES (11, 1, 'base_acceleration', 'wheelset_1', 'm/s^2', 18.17697359500222, 17.72236015206911, -18.17697359500222, -0.4621690845330917, 12.541464907216149, 12.549977780125042, 0.1447, 37.05833333333334, 300, NULL);
INSERT INTO public.peak VALUES (12, 1, 'slab_moment', 'wheelset_1', 'N m', 7087.890236512035, 7087.890236512035, 1324.0704276470206, 3750.2774876160884, 1457.2903709616444, 4023.465727382, 0.129, 35.75, 300, NULL);
INSERT INTO public.peak VALUES (13, 1, 'roadbed_pressure', 'wheelset_1', 'N/m', 29737.030411307565, 29737.030411307565, 20158.70521258235, 24869.699932946387, 3353.58558460171, 25094.790515723416, 0.10740000000000001, 33.95, 300, NULL);
INSERT INTO public.peak VALUES (14, 1, 'pad_force', 'pads', 'N', 49315.67425786069, 49315.67425786069, 31430.271439560274, 41802.3067239934, 4010.86768622959, 41994.28421872749, 0.1516, 37.63333333333333, 300, NULL);
INSERT INTO public.peak VALUES (15, 1, 'pad_uplift', 'pads', 'N', 2642.2582740972157, 2642.2582740972157, 1141.2770083404328, 1999.6881807906284, 404.24596554261143, 2040.1391180630824, 0.16340000000000002, 38.61666666666667, 300, NULL);
INSERT INTO public.peak VALUES (16, 1, 'car_body_acceleration', 'car_body', 'm/s^2', 0.0013688540473698844, 0.0011400843472411657, -0.0013688540473698844, 1.150829067494849e-05, 0.0007863787862510722, 0.0007864629910046426, 0.0753, 31.275, 300, NULL);
INSERT INTO public.peak VALUES (17, 1, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.12088327355392053, 0.12088327355392053, -0.10239413971896502, 0.0011514264133570045, 0.0611364588326911, 0.061147300687656767, 0.125, 35.41666666666667, 300, NULL);
INSERT INTO public.peak VALUES (18, 1, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.19437860662216164, 0.1622754217604304, -0.19437860662216164, -0.0003737788402942108, 0.10639744499041166, 0.10639810153902712, 0.049, 29.083333333333336, 300, NULL);
INSERT INTO public.peak VALUES (19, 1, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 35.42462748919693, 34.845480001249605, -35.42462748919693, 0.09921074381389929, 24.58973884176316, 24.589938980766178, 0.1274, 35.61666666666667, 300, NULL);
INSERT INTO public.peak VALUES (20, 1, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 34.16232803201725, 33.52104282265634, -34.16232803201725, -0.0993221684260593, 23.682901090016188, 23.683109359470322, 0.025400000000000002, 27.116666666666667, 300, NULL);
INSERT INTO public.peak VALUES (21, 1, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 29.20140105043805, 28.71854566566072, -29.20140105043805, 0.29318828115597545, 20.138576709421404, 20.140710793054385, 0.0477, 28.974999999999998, 300, NULL);
INSERT INTO public.peak VALUES (22, 1, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 27.403792840246204, 26.90076230693269, -27.403792840246204, -0.25054312139387297, 18.890501631662, 18.892163024691015, 0.0779, 31.491666666666667, 300, NULL);
INSERT INTO public.peak VALUES (23, 1, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 70334.14202135979, 70334.14202135979, 63202.09329900042, 68463.47641841524, 1276.4473080544933, 68475.37455921757, 0.2, 41.666666666666664, 300, NULL);
INSERT INTO public.peak VALUES (24, 1, 'wheel_unloading', 'wheelset_1', '1', 0.6136274148163111, 0.6136274148163111, -0.6234078420980852, 0.002526241552849587, 0.43259716894353795, 0.43260454513833674, 0.1096, 34.13333333333333, 300, NULL);
INSERT INTO public.peak VALUES (25, 1, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (26, 1, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 73949.50298363682, 73949.50298363682, 67131.31891880682, 68873.61488508954, 1228.1853381931273, 68884.56479186453, 0.0004, 25.03333333333333, 300, NULL);
INSERT INTO public.peak VALUES (27, 1, 'wheel_unloading', 'wheelset_2', '1', 0.5898201182357272, 0.5898201182357272, -0.6011393637838749, -0.002497372576420746, 0.4165996039062295, 0.4166070892875118, 0.1395, 36.625, 300, NULL);
INSERT INTO public.peak VALUES (28, 1, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (29, 1, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 69343.81319124879, 69343.81319124879, 63796.16288628076, 68363.51302976745, 1076.3291574641632, 68371.9854781649, 0.166, 38.833333333333336, 300, NULL);
INSERT INTO public.peak VALUES (30, 1, 'wheel_unloading', 'wheelset_3', '1', 0.505409501244608, 0.505409501244608, -0.5142320465431617, 0.004630867131384545, 0.35461272924750736, 0.35464296507156956, 0.16190000000000002, 38.49166666666667, 300, NULL);
INSERT INTO public.peak VALUES (31, 1, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (32, 1, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 73008.25752765602, 73008.25752765602, 68069.94894632511, 68924.632146822, 963.0736433491597, 68931.36026089461, 0.2, 41.666666666666664, 300, NULL);
INSERT INTO public.peak VALUES (33, 1, 'wheel_unloading', 'wheelset_4', '1', 0.4733385276640697, 0.4733385276640697, -0.48219058976418283, -0.0038949933628005962, 0.3325963675610828, 0.33261917366279886, 0.1681, 39.00833333333333, 300, NULL);
INSERT INTO public.peak VALUES (34, 1, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (35, 1, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.00024090092484688367, -3.9877246916542555e-05, -0.00024090092484688367, -9.103624134642599e-05, 5.6713369060557496e-05, 0.00010725671759234346, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (36, 1, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 111408.1327444588, 111408.1327444588, 111408.1327444588, 111408.1327444588, 0, 111408.1327444588, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (37, 1, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (38, 1, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (39, 1, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 109924.53099861827, 109924.53099861827, 109924.53099861827, 109924.53099861827, 0, 109924.53099861827, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (40, 1, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (41, 1, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (42, 1, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 103950.93843943799, 103950.93843943799, 103950.93843943799, 103950.93843943799, 0, 103950.93843943799, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (43, 1, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (44, 1, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (45, 1, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 101737.07009258146, 101737.07009258146, 101737.07009258146, 101737.07009258146, 0, 101737.07009258146, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (46, 1, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (47, 1, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (48, 1, 'sperling_index', 'car_body', '1', 0.23345452523974547, 0.23345452523974547, 0.23345452523974547, 0.23345452523974547, 0, 0.23345452523974547, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (49, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 70333.27957286355, 70333.27957286355, 70333.27957286355, 70333.27957286355, 0, 70333.27957286355, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (50, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 73948.947830962, 73948.947830962, 73948.947830962, 73948.947830962, 0, 73948.947830962, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (51, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 69343.60062018219, 69343.60062018219, 69343.60062018219, 69343.60062018219, 0, 69343.60062018219, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (52, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 73006.18521573115, 73006.18521573115, 73006.18521573115, 73006.18521573115, 0, 73006.18521573115, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (53, 2, 'wheel_rail_force', 'wheelset_1', 'N', 110412.46026717729, 110412.46026717729, 27390.451132251837, 68508.19640252042, 28884.865341321944, 74348.56030961605, 0.0195, 26.625, 300, NULL);
INSERT INTO public.peak VALUES (54, 2, 'wheel_rail_force', 'wheelset_2', 'N', 109280.07498452124, 109280.07498452124, 28317.83344710547, 68843.91120023512, 28120.166292589867, 74365.50182489704, 0.0495, 29.125, 300, NULL);
INSERT INTO public.peak VALUES (55, 2, 'wheel_rail_force', 'wheelset_3', 'N', 104833.26584714853, 104833.26584714853, 33034.68734204502, 68320.44581101448, 24789.948940597056, 72678.91636708114, 0.0717, 30.975, 300, NULL);
INSERT INTO public.peak VALUES (56, 2, 'wheel_rail_force', 'wheelset_4', 'N', 102270.01261976743, 102270.01261976743, 35228.15625038206, 68971.95273662136, 22896.423289521532, 72673.07936062483, 0.1018, 33.483333333333334, 300, NULL);
INSERT INTO public.peak VALUES (57, 2, 'rail_displacement', 'wheelset_1', 'm', 0.0013659518489405257, 0.0013659518489405257, 0.0006143076721018549, 0.0009855656220631639, 0.00026051862322085296, 0.0010194162782875503, 0.0206, 26.716666666666665, 300, NULL);
INSERT INTO public.peak VALUES (58, 2, 'rail_acceleration', 'wheelset_1', 'm/s^2', 131.65628664399378, 99.10337407566693, -131.65628664399378, -12.776230838310374, 79.57134854130169, 80.59051794792677, 0.1285, 35.708333333333336, 300, NULL);
INSERT INTO public.peak VALUES (59, 2, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 102.89779940410021, 101.0474975844432, -102.89779940410021, 1.2125813414031128, 71.45436176717692, 71.46464978619929, 0.1285, 35.708333333333336, 300, NULL);
INSERT INTO public.peak VALUES (60, 2, 'slab_displacement', 'wheelset_1', 'm', 0.0005104213564926113, 0.0005104213564926113, 0.00038452783007502994, 0.0004417906020303647, 3.2681505632189677e-05, 0.0004429977616791522, 0.0954, 32.95, 300, NULL);
INSERT INTO public.peak VALUES (61, 2, 'slab_acceleration', 'wheelset_1', 'm/s^2', 17.273914218027603, 15.01569973032419, -17.273914218027603, -0.6435417260445275, 9.22415739345914, 9.246579128113666, 0.0952, 32.93333333333333, 300, NULL);
INSERT INTO public.peak VALUES (62, 2, 'base_displacement', 'wheelset_1', 'm', 0.00047170869243488075, 0.00047170869243488075, 0.00033603195163486746, 0.00040442656216055074, 4.101942361792709e-05, 0.0004065014603847676, 0.024300000000000002, 27.025000000000002, 300, NULL);
INSERT INTO public.peak VALUES (63, 2, 'base_acceleration', 'wheelset_1', 'm/s^2', 18.38002551927905, 17.60148892425387, -18.38002551927905, -0.43244978504578274, 11.56837705468208, 11.576457165120983, 0.024300000000000002, 27.025000000000002, 300, NULL);
INSERT INTO public.peak VALUES (64, 2, 'slab_moment', 'wheelset_1', 'N m', 7648.254584099806, 7648.254584099806, 63.324781796766516, 3087.262557668176, 1853.2418809036885, 3600.790964373701, 0.1291, 35.75833333333333, 300, NULL);
INSERT INTO public.peak VALUES (65, 2, 'roadbed_pressure', 'wheelset_1', 'N/m', 30175.980778481113, 30175.980778481113, 19908.657140233983, 25007.431385345888, 3120.7632462593106, 25201.404479353634, 0.023100000000000002, 26.924999999999997, 300, NULL);
INSERT INTO public.peak VALUES (66, 2, 'pad_force', 'pads', 'N', 48588.465525900116, 48588.465525900116, 31843.838774051743, 41707.493876003115, 3723.778960535609, 41873.399374349414, 0.1515, 37.625, 300, NULL);
INSERT INTO public.peak VALUES (67, 2, 'pad_uplift', 'pads', 'N', 2763.0306441141, 2763.0306441141, 1114.8758418839855, 2029.1697683348395, 401.71541707579, 2068.5514799106263, 0.079, 31.583333333333332, 300, NULL);
INSERT INTO public.peak VALUES (68, 2, 'car_body_acceleration', 'car_body', 'm/s^2', 0.001961189064617467, 0.001961189064617467, -0.0015759471269780802, -4.415563247355912e-05, 0.0008859441549845972, 0.0008870438352361805, 0.1051, 33.75833333333333, 300, NULL);
INSERT INTO public.peak VALUES (69, 2, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.13195601530496315, 0.13195601530496315, -0.11724089606565058, -0.0002535477858127131, 0.05273572700527315, 0.05273633651719076, 0.17170000000000002, 39.30833333333333, 300, NULL);
INSERT INTO public.peak VALUES (70, 2, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.24817676787051082, 0.22932148748765654, -0.24817676787051082, -0.0017961617579460656, 0.1213749008583328, 0.12138819034581091, 0.158, 38.166666666666664, 300, NULL);
INSERT INTO public.peak VALUES (71, 2, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 34.61755267806631, 34.09373713981687, -34.61755267806631, 0.09260235028443804, 23.909920349471044, 23.91009967175645, 0.0193, 26.608333333333334, 300, NULL);
INSERT INTO public.peak VALUES (72, 2, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 33.69083768432323, 33.340437967241655, -33.69083768432323, -0.10195103677979643, 23.27878913836552, 23.279012388037103, 0.049300000000000004, 29.10833333333333, 300, NULL);
INSERT INTO public.peak VALUES (73, 2, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 30.010350265965986, 29.426327905368588, -30.010350265965986, 0.3186383018773074, 20.50119630287613, 20.5036723592747, 0.0716, 30.96666666666667, 300, NULL);
INSERT INTO public.peak VALUES (74, 2, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 27.88972936663102, 27.630820165333922, -27.88972936663102, -0.27624253426736495, 18.938131664382407, 18.940146273860243, 0.1017, 33.475, 300, NULL);
INSERT INTO public.peak VALUES (75, 2, 'joint_opening', 'joints', 'm', 5.31621295499431e-05, 5.1373774284530925e-05, -5.31621295499431e-05, -2.7091913928872606e-08, 2.8247240406611287e-05, 2.8247253398528745e-05, 0.1351, 36.25833333333333, 300, NULL);
INSERT INTO public.peak VALUES (76, 2, 'joint_slope_jump', 'joints', 'rad', 0.00031700024758024743, 0.00029336433178372344, -0.00031700024758024743, 4.8686433576128675e-05, 0.00018852398588903335, 0.0001947091730500934, 0.17650000000000002, 39.708333333333336, 300, NULL);
INSERT INTO public.peak VALUES (77, 2, 'joint_shear', 'joints', 'N', 5669.119096845746, 5347.940473216286, -5669.119096845746, -18.849431769664633, 2981.9613045443507, 2982.020879014412, 0.13440000000000002, 36.199999999999996, 300, NULL);
INSERT INTO public.peak VALUES (78, 2, 'slab_moment', 'joints', 'N m', 5662.020377650853, 5662.020377650853, -2382.290061551983, 2480.9937264916516, 1674.209292093627, 2993.0430375495057, 0.10260000000000001, 33.55, 300, NULL);
INSERT INTO public.peak VALUES (79, 2, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 70293.93340675367, 70293.93340675367, 63346.13991726781, 68475.97194785297, 1241.615639310403, 68487.22759463203, 0.2, 41.666666666666664, 300, NULL);
INSERT INTO public.peak VALUES (80, 2, 'wheel_unloading', 'wheelset_1', '1', 0.6011292976226614, 0.6011292976226614, -0.6078703985317794, 0.0023562486890866437, 0.420632959681403, 0.42063955909807343, 0.08560000000000001, 32.13333333333333, 300, NULL);
INSERT INTO public.peak VALUES (81, 2, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (82, 2, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 73943.59935014993, 73943.59935014993, 67261.10152828532, 68875.72406668594, 1216.1087398311602, 68886.4593819232, 0.0004, 25.03333333333333, 300, NULL);
INSERT INTO public.peak VALUES (83, 2, 'wheel_unloading', 'wheelset_2', '1', 0.5876243855088762, 0.5876243855088762, -0.5913801512235509, -0.002532564442043393, 0.4094971063432339, 0.40950493768223956, 0.0436, 28.633333333333333, 300, NULL);
INSERT INTO public.peak VALUES (84, 2, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (85, 2, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 69358.45056453663, 69358.45056453663, 63734.96963109538, 68329.9331395317, 1099.710203738784, 68338.7820010357, 0.1653, 38.775, 300, NULL);
INSERT INTO public.peak VALUES (86, 2, 'wheel_unloading', 'wheelset_3', '1', 0.5189356728987182, 0.5189356728987182, -0.5266239383595243, 0.005090347880960056, 0.36100114956454143, 0.36103703636672735, 0.1139, 34.49166666666667, 300, NULL);
INSERT INTO public.peak VALUES (87, 2, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (88, 2, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 73060.48034235307, 73060.48034235307, 68052.64922442655, 68960.86860189473, 974.5604850392341, 68967.75454128394, 0.2, 41.666666666666664, 300, NULL);
INSERT INTO public.peak VALUES (89, 2, 'wheel_unloading', 'wheelset_4', '1', 0.48699350152348825, 0.48699350152348825, -0.4892968198597266, -0.004397156496597699, 0.3334268718439134, 0.33345586492498974, 0.096, 33, 300, NULL);
INSERT INTO public.peak VALUES (90, 2, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (91, 2, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.0002771270326358211, 5.129287649904025e-05, -0.0002771270326358211, -2.5230572804694777e-05, 8.428044235826246e-05, 8.79759897253643e-05, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (92, 2, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 110367.05774775188, 110367.05774775188, 110367.05774775188, 110367.05774775188, 0, 110367.05774775188, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (93, 2, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (94, 2, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (95, 2, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 109249.76274710933, 109249.76274710933, 109249.76274710933, 109249.76274710933, 0, 109249.76274710933, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (96, 2, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (97, 2, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (98, 2, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 104666.85719279424, 104666.85719279424, 104666.85719279424, 104666.85719279424, 0, 104666.85719279424, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (99, 2, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (100, 2, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (101, 2, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 102148.9170568734, 102148.9170568734, 102148.9170568734, 102148.9170568734, 0, 102148.9170568734, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (102, 2, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (103, 2, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (104, 2, 'sperling_index', 'car_body', '1', 0.2756015928009909, 0.2756015928009909, 0.2756015928009909, 0.2756015928009909, 0, 0.2756015928009909, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (105, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 70293.19331862804, 70293.19331862804, 70293.19331862804, 70293.19331862804, 0, 70293.19331862804, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (106, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 73942.81618390643, 73942.81618390643, 73942.81618390643, 73942.81618390643, 0, 73942.81618390643, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (107, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 69358.2774136908, 69358.2774136908, 69358.2774136908, 69358.2774136908, 0, 69358.2774136908, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (108, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 73058.606516579, 73058.606516579, 73058.606516579, 73058.606516579, 0, 73058.606516579, 0.0001, 25.008333333333336, 300, NULL);
INSERT INTO public.peak VALUES (109, 3, 'wheel_rail_force', 'wheelset_1', 'N', 73161.5999940933, 73161.5999940933, 64282.78697012658, 68892.88022328835, 1499.5562960420677, 68909.19833045045, 0.007766808510638299, 21.37393617021277, 250, 25);
INSERT INTO public.peak VALUES (110, 3, 'wheel_rail_force', 'wheelset_2', 'N', 73183.4128371613, 73183.4128371613, 65396.69162526433, 68733.45041574148, 1531.0186146718643, 68750.49980946803, 0.044310638297872344, 23.911702127659574, 250, 25);
INSERT INTO public.peak VALUES (111, 3, 'wheel_rail_force', 'wheelset_3', 'N', 72975.35399970812, 72975.35399970812, 64206.941073722955, 68594.14480984221, 2170.7617412216578, 68628.48467459233, 0.10853617021276597, 28.371808510638303, 250, 25);
INSERT INTO public.peak VALUES (112, 3, 'wheel_rail_force', 'wheelset_4', 'N', 73208.51272546877, 73208.51272546877, 64045.90755557481, 68757.52564803202, 2253.7870344689572, 68794.45391335351, 0.02230468085106383, 22.383510638297874, 250, 25);
INSERT INTO public.peak VALUES (113, 3, 'rail_displacement', 'wheelset_1', 'm', 0.0009736391010701425, 0.0009736391010701425, 0.0008718615895808764, 0.0009228504404346784, 2.0334634974002373e-05, 0.0009230744459630577, 0.013044255319148938, 21.740425531914894, 250, 25);
INSERT INTO public.peak VALUES (114, 3, 'rail_acceleration', 'wheelset_1', 'm/s^2', 12.957487957249338, -7.123240705652879, -12.957487957249338, -9.540604523150902, 1.2112644218661477, 9.6171875393405, 0.008364255319148937, 21.415425531914895, 250, 25);
INSERT INTO public.peak VALUES (115, 3, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 1.776447523039333, 1.2524230928039477, -1.776447523039333, -0.04933386251348038, 0.4832330678145796, 0.4857448175945772, 0.010156595744680853, 21.539893617021278, 250, 25);
INSERT INTO public.peak VALUES (116, 3, 'slab_displacement', 'wheelset_1', 'm', 0.00047217766480013237, 0.00047217766480013237, 0.0004139611855162644, 0.00044064245944733926, 1.2452787662201667e-05, 0.0004408183854926651, 0.015234893617021279, 21.892553191489363, 250, 25);
INSERT INTO public.peak VALUES (117, 3, 'slab_acceleration', 'wheelset_1', 'm/s^2', 1.5412834292996929, 0.436134660542726, -1.5412834292996929, -0.6052723155691642, 0.374025223037533, 0.7115120824432528, 0.019417021276595746, 22.182978723404258, 250, 25);
INSERT INTO public.peak VALUES (118, 3, 'base_displacement', 'wheelset_1', 'm', 0.0004337172928590861, 0.0004337172928590861, 0.0003773370868564555, 0.0004035988982403219, 1.180240590701949e-05, 0.00040377142970497026, 0.01463744680851064, 21.851063829787236, 250, 25);
INSERT INTO public.peak VALUES (119, 3, 'base_acceleration', 'wheelset_1', 'm/s^2', 1.3711095112639726, 0.8066906237067979, -1.3711095112639726, -0.3945166385326703, 0.4094944167031212, 0.5686203086332278, 0.02101021276595745, 22.2936170212766, 250, 25);
INSERT INTO public.peak VALUES (120, 3, 'slab_moment', 'wheelset_1', 'N m', 5417.062948473847, 5417.062948473847, 2863.0633956052084, 3968.3958538254205, 709.1557251247485, 4031.2612784507032, 0.008762553191489362, 21.44308510638298, 250, 25);
INSERT INTO public.peak VALUES (121, 3, 'roadbed_pressure', 'wheelset_1', 'N/m', 26773.39524121713, 26773.39524121713, 23143.0757361347, 24851.134114334774, 753.594897650173, 24862.557632681677, 0.01294468085106383, 21.733510638297876, 250, 25);
INSERT INTO public.peak VALUES (122, 3, 'pad_force', 'pads', 'N', 30829.94858655749, 30829.94858655749, 26508.021148768275, 28966.77861133126, 898.8519163819926, 28980.72114157034, 0.044310638297872344, 23.911702127659574, 250, 25);
INSERT INTO public.peak VALUES (123, 3, 'pad_uplift', 'pads', 'N', 1187.725170582198, 1187.725170582198, 985.4460461546852, 1101.3631277626848, 39.990755274832544, 1102.0889254967838, 0.004182127659574469, 21.125, 250, 25);
INSERT INTO public.peak VALUES (124, 3, 'car_body_acceleration', 'car_body', 'm/s^2', 0.028166047281719852, 0.02274748434127702, -0.028166047281719852, -0.0015056756524798882, 0.014315989402532788, 0.014394950911479408, 0.0668144680851064, 25.474468085106388, 250, 25);
INSERT INTO public.peak VALUES (125, 3, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.6814352123077525, 0.4770871589697109, -0.6814352123077525, -0.06197385079077548, 0.27865641683103937, 0.2854648083791613, 0.05466638297872341, 24.63085106382979, 250, 25);
INSERT INTO public.peak VALUES (126, 3, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.7280823129667219, 0.5403451729042065, -0.7280823129667219, 0.0025777542963334307, 0.2934022641406897, 0.2934135876541768, 0.15682978723404256, 31.725531914893622, 250, 25);
INSERT INTO public.peak VALUES (127, 3, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 3.415508833284411, 3.2257440419187726, -3.415508833284411, -0.08262131037806156, 1.1219932576259362, 1.1250311778287072, 0.007667234042553192, 21.367021276595747, 250, 25);
INSERT INTO public.peak VALUES (128, 3, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 3.6061325414954624, 2.2205511559565867, -3.6061325414954624, -0.06809091488489524, 1.1055166037139996, 1.107611544620766, 0.04401191489361703, 23.890957446808514, 250, 25);
INSERT INTO public.peak VALUES (129, 3, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 3.7293640237074177, 3.7293640237074177, -3.1420335542680853, 0.054463781888289584, 1.6077770549650436, 1.6086992764372228, 0.13183659574468087, 29.989893617021277, 250, 25);
INSERT INTO public.peak VALUES (130, 3, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 3.3836161907302342, 3.3836161907302342, -2.9996885697805062, -0.0477964146075968, 1.6319257008272, 1.632625489899533, 0.11132425531914895, 28.565425531914897, 250, 25);
INSERT INTO public.peak VALUES (131, 3, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 71858.00966365101, 71858.00966365101, 66954.51031348621, 68895.45077513486, 1090.5007195810329, 68904.08064351804, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (132, 3, 'wheel_unloading', 'wheelset_1', '1', 0.06388835051512187, 0.06388835051512187, -0.06540847523071641, -0.0032456709376489216, 0.0218371384307859, 0.022077024135530705, 0.20004510638297873, 34.72659574468086, 250, 25);
INSERT INTO public.peak VALUES (133, 3, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (134, 3, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 70480.83341457644, 70480.83341457644, 67036.57239562878, 68733.31918161502, 906.4747417931278, 68739.29634626234, 0.04948851063829788, 24.271276595744684, 250, 25);
INSERT INTO public.peak VALUES (135, 3, 'wheel_unloading', 'wheelset_2', '1', 0.04766722549491295, 0.04766722549491295, -0.06572612257406879, -0.0009239903268017599, 0.02229530529593511, 0.022314443671375174, 0.021508085106382982, 22.328191489361707, 250, 25);
INSERT INTO public.peak VALUES (136, 3, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (137, 3, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 71523.48203744604, 71523.48203744604, 65840.91281764074, 68594.63997372639, 1563.455770253752, 68612.4553348055, 0.10863574468085108, 28.37872340425532, 250, 25);
INSERT INTO public.peak VALUES (138, 3, 'wheel_unloading', 'wheelset_3', '1', 0.06499284878807404, 0.06499284878807404, -0.06269628658377929, 0.001104633612316773, 0.031611500527474266, 0.03163079482112275, 0.07537787234042553, 26.069148936170215, 250, 25);
INSERT INTO public.peak VALUES (139, 3, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (140, 3, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 71442.11996076356, 71442.11996076356, 65849.93639387586, 68749.32865811956, 1566.3106620074072, 68767.16891098584, 0.1448808510638298, 30.895744680851067, 250, 25);
INSERT INTO public.peak VALUES (141, 3, 'wheel_unloading', 'wheelset_4', '1', 0.06733788327399427, 0.06733788327399427, -0.0660916371846333, -0.0012745834867046784, 0.032820548048186356, 0.03284528790021317, 0.11202127659574469, 28.613829787234046, 250, 25);
INSERT INTO public.peak VALUES (142, 3, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (143, 3, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.025668534627842732, 0.025668534627842732, -0.019225340053196465, 0.00358359911083084, 0.011879787244562536, 0.012408526405791234, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (144, 3, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 73151.40525177978, 73151.40525177978, 73151.40525177978, 73151.40525177978, 0, 73151.40525177978, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (145, 3, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (146, 3, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (147, 3, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 73174.85114415213, 73174.85114415213, 73174.85114415213, 73174.85114415213, 0, 73174.85114415213, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (148, 3, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (149, 3, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (150, 3, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 72963.34713237033, 72963.34713237033, 72963.34713237033, 72963.34713237033, 0, 72963.34713237033, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (151, 3, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (152, 3, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (153, 3, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 73203.28620211329, 73203.28620211329, 73203.28620211329, 73203.28620211329, 0, 73203.28620211329, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (154, 3, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (155, 3, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (156, 3, 'sperling_index', 'car_body', '1', 0.9234412555910214, 0.9234412555910214, 0.9234412555910214, 0.9234412555910214, 0, 0.9234412555910214, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (157, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 71856.84402525052, 71856.84402525052, 71856.84402525052, 71856.84402525052, 0, 71856.84402525052, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (158, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 70480.63229920412, 70480.63229920412, 70480.63229920412, 70480.63229920412, 0, 70480.63229920412, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (159, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 71523.06149266391, 71523.06149266391, 71523.06149266391, 71523.06149266391, 0, 71523.06149266391, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (160, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 71441.68802055507, 71441.68802055507, 71441.68802055507, 71441.68802055507, 0, 71441.68802055507, 9.95744680851064e-05, 20.841489361702127, 250, 25);
INSERT INTO public.peak VALUES (161, 4, 'wheel_rail_force', 'wheelset_1', 'N', 102546.96152802046, 102546.96152802046, 35274.86213504713, 69086.87128790583, 8731.438583900474, 69636.44020264168, 0.0036842553191489364, 21.090425531914896, 250, NULL);
INSERT INTO public.peak VALUES (162, 4, 'wheel_rail_force', 'wheelset_2', 'N', 119456.13874586251, 119456.13874586251, 12736.867461361666, 69171.96673055128, 14723.910746082765, 70721.66944459884, 0.004082553191489362, 21.118085106382978, 250, NULL);
INSERT INTO public.peak VALUES (163, 4, 'wheel_rail_force', 'wheelset_3', 'N', 124408.49193683093, 124408.49193683093, 13308.772769238132, 68781.7607350693, 32447.27727532095, 76051.01190909876, 0.18261957446808513, 33.51648936170213, 250, NULL);
INSERT INTO public.peak VALUES (164, 4, 'wheel_rail_force', 'wheelset_4', 'N', 120525.87535062831, 120525.87535062831, 8048.129936975804, 68933.23834095619, 31398.139523180474, 75747.17495516372, 0.20004510638297873, 34.72659574468086, 250, NULL);
INSERT INTO public.peak VALUES (165, 4, 'rail_displacement', 'wheelset_1', 'm', 0.0011048260635735687, 0.0011048260635735687, 0.0007547998804996069, 0.000921464357076382, 4.3855402195120334e-05, 0.0009225073753980972, 0.004879148936170213, 21.173404255319152, 250, NULL);
INSERT INTO public.peak VALUES (166, 4, 'rail_acceleration', 'wheelset_1', 'm/s^2', 47.19110503756563, 28.40079816911997, -47.19110503756563, -9.642291174956565, 8.031839777156643, 12.549272062895156, 0.0052774468085106385, 21.201063829787238, 250, NULL);
INSERT INTO public.peak VALUES (167, 4, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 37.77961605244235, 33.74062508611199, -37.77961605244235, -0.16540982479742167, 7.245601908646789, 7.2474897329161845, 0.0052774468085106385, 21.201063829787238, 250, NULL);
INSERT INTO public.peak VALUES (168, 4, 'slab_displacement', 'wheelset_1', 'm', 0.0005023786261485533, 0.0005023786261485533, 0.0003557807320355315, 0.0004378360654677735, 1.8473969835865426e-05, 0.0004382256357012868, 0.011451063829787235, 21.629787234042556, 250, NULL);
INSERT INTO public.peak VALUES (169, 4, 'slab_acceleration', 'wheelset_1', 'm/s^2', 11.11780684077879, 10.55371012466123, -11.11780684077879, -0.45080835606427677, 3.2770592180349296, 3.307921597076491, 0.012745531914893618, 21.71968085106383, 250, NULL);
INSERT INTO public.peak VALUES (170, 4, 'base_displacement', 'wheelset_1', 'm', 0.0004773744900397367, 0.0004773744900397367, 0.00031112977878523606, 0.0004007900079139696, 2.1087349218830997e-05, 0.0004013443742482966, 0.011251914893617022, 21.615957446808512, 250, NULL);
INSERT INTO public.peak VALUES (171, 4, 'base_acceleration', 'wheelset_1', 'm/s^2', 11.57067958333393, 10.707635238778856, -11.57067958333393, -0.23476953234230186, 3.399070917020081, 3.4071688881310176, 0.01214808510638298, 21.6781914893617, 250, NULL);
INSERT INTO public.peak VALUES (172, 4, 'slab_moment', 'wheelset_1', 'N m', 6264.315439494514, 6264.315439494514, 1977.0766247714353, 3948.031961241894, 840.0718917755972, 4036.418852192987, 0.018122553191489362, 22.09308510638298, 250, NULL);
INSERT INTO public.peak VALUES (173, 4, 'roadbed_pressure', 'wheelset_1', 'N/m', 30375.240455051397, 30375.240455051397, 18213.317098231815, 24708.98438300351, 1504.2901808975143, 24754.732844202867, 0.009957446808510639, 21.526063829787237, 250, NULL);
INSERT INTO public.peak VALUES (174, 4, 'pad_force', 'pads', 'N', 53295.92881666979, 53295.92881666979, 20599.392452006578, 34549.15094404111, 8125.391472736001, 35491.7711242951, 0.16469617021276597, 32.2718085106383, 250, NULL);
INSERT INTO public.peak VALUES (175, 4, 'pad_uplift', 'pads', 'N', 2431.2153149531528, 2431.2153149531528, 734.7307893789141, 1368.0172990093201, 446.92564400650775, 1439.1712412563654, 0.20004510638297873, 34.72659574468086, 250, NULL);
INSERT INTO public.peak VALUES (176, 4, 'car_body_acceleration', 'car_body', 'm/s^2', 0.06355679291535273, 0.057595098247747153, -0.06355679291535273, 0.0009876311339767688, 0.04210556992272619, 0.04211715130174861, 0.08085446808510639, 26.449468085106385, 250, NULL);
INSERT INTO public.peak VALUES (177, 4, 'bogie_acceleration', 'bogie_1', 'm/s^2', 6.310522098912399, 5.007771008118196, -6.310522098912399, -0.06745323783196609, 1.5471784969604385, 1.5486481978650855, 0.006671489361702128, 21.297872340425535, 250, NULL);
INSERT INTO public.peak VALUES (178, 4, 'bogie_acceleration', 'bogie_2', 'm/s^2', 7.842081904150224, 6.464544494093255, -7.842081904150224, 0.06986959923035195, 4.317997482943207, 4.318562726602508, 0.18500936170212767, 33.68244680851064, 250, NULL);
INSERT INTO public.peak VALUES (179, 4, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 27.93558357852409, 27.93558357852409, -27.164644162938227, -0.3179456236272006, 7.188069841457632, 7.195098155359413, 0.010654468085106384, 21.574468085106385, 250, NULL);
INSERT INTO public.peak VALUES (180, 4, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 46.88621852857219, 46.88621852857219, -39.898778562653014, -0.36532649343777124, 12.098876696636422, 12.10439097052055, 0.010654468085106384, 21.574468085106385, 250, NULL);
INSERT INTO public.peak VALUES (181, 4, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 46.43795436083721, 46.43795436083721, -44.268145795038784, -0.13988118614642078, 26.55255094581736, 26.55291939648942, 0.09907659574468086, 27.71489361702128, 250, NULL);
INSERT INTO public.peak VALUES (182, 4, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 50.437668810176724, 50.437668810176724, -40.80147935761762, -0.27472660966820983, 25.666882493366003, 25.668352725453925, 0.18879319148936172, 33.94521276595745, 250, NULL);
INSERT INTO public.peak VALUES (183, 4, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 75781.36351706501, 75781.36351706501, 67643.204441086, 69080.70590870373, 1547.7144417439981, 69098.04157020658, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (184, 4, 'wheel_unloading', 'wheelset_1', '1', 0.48631335175408286, 0.48631335175408286, -0.49332986060900624, -0.006070646394434523, 0.12715070021698666, 0.1272955353235779, 0.010953191489361703, 21.59521276595745, 250, NULL);
INSERT INTO public.peak VALUES (185, 4, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (186, 4, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 77239.97667574791, 77239.97667574791, 67419.698411772, 69159.86679400135, 1873.3997285808716, 69185.23543001829, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (187, 4, 'wheel_unloading', 'wheelset_2', '1', 0.8145206427645018, 0.8145206427645018, -0.7395680609562038, -0.0073098402585015125, 0.21441547613343184, 0.21454004327894383, 0.010853617021276596, 21.588297872340426, 250, NULL);
INSERT INTO public.peak VALUES (188, 4, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (189, 4, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 69473.10591573005, 69473.10591573005, 68534.818205479, 68754.42760837579, 218.68865721103137, 68754.77540130707, 0.199348085106383, 34.6781914893617, 250, NULL);
INSERT INTO public.peak VALUES (190, 4, 'wheel_unloading', 'wheelset_3', '1', 0.806192328975708, 0.806192328975708, -0.8116862084874171, -0.0016275045153532253, 0.472510226814052, 0.472513029677293, 0.09927574468085107, 27.728723404255323, 250, NULL);
INSERT INTO public.peak VALUES (191, 4, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (192, 4, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 72478.17657024617, 72478.17657024617, 68104.10454482838, 68911.66710796708, 832.8423041064478, 68916.69964459108, 0.19994553191489364, 34.719680851063835, 250, NULL);
INSERT INTO public.peak VALUES (193, 4, 'wheel_unloading', 'wheelset_4', '1', 0.8827999135433843, 0.8827999135433843, -0.7551459931648218, -0.003833381985673328, 0.45723226333450523, 0.45724833236595014, 0.18899234042553192, 33.959042553191495, 250, NULL);
INSERT INTO public.peak VALUES (194, 4, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (195, 4, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.008153012536096717, 0.001993814922921898, -0.008153012536096717, -0.005093782749807748, 0.0028901994134943564, 0.00585660954409649, 0.05157957446808511, 24.41648936170213, 250, NULL);
INSERT INTO public.peak VALUES (196, 4, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 102493.56186562165, 102493.56186562165, 102493.56186562165, 102493.56186562165, 0, 102493.56186562165, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (197, 4, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (198, 4, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (199, 4, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 119348.39489489087, 119348.39489489087, 119348.39489489087, 119348.39489489087, 0, 119348.39489489087, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (200, 4, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (201, 4, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (202, 4, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 124254.67934963561, 124254.67934963561, 124254.67934963561, 124254.67934963561, 0, 124254.67934963561, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (203, 4, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (204, 4, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (205, 4, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 120398.43627403933, 120398.43627403933, 120398.43627403933, 120398.43627403933, 0, 120398.43627403933, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (206, 4, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (207, 4, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (208, 4, 'sperling_index', 'car_body', '1', 1.0091850498649528, 1.0091850498649528, 1.0091850498649528, 1.0091850498649528, 0, 1.0091850498649528, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (209, 4, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 75776.1397859939, 75776.1397859939, 75776.1397859939, 75776.1397859939, 0, 75776.1397859939, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (210, 4, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 77234.07893505746, 77234.07893505746, 77234.07893505746, 77234.07893505746, 0, 77234.07893505746, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (211, 4, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 69473.00003589838, 69473.00003589838, 69473.00003589838, 69473.00003589838, 0, 69473.00003589838, 9.95744680851064e-05, 20.841489361702127, 250, NULL);
INSERT INTO public.peak VALUES (212, 4, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 72477.39298446772, 72477.39298446772, 72477.39298446772, 72477.39298446772, 0, 72477.39298446772, 9.95744680851064e-05, 20.841489361702127, 250, NULL);


--
-- Data for Name: profile; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.profile VALUES ('93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e', '\x0000000000000000000000000000d03f000000000000e03f000000000000e83f000000000000f03f000000000000f43f000000000000f83f000000000000fc3f000000000000004000000000000002400000000000000440000000000000064000000000000008400000000000000a400000000000000c400000000000000e4000000000000010400000000000001140000000000000124000000000000013400000000000001440000000000000154000000000000016400000000000001740000000000000184000000000000019400000000000001a400000000000001b400000000000001c400000000000001d400000000000001e400000000000001f40000000000000204000000000008020400000000000002140000000000080214000000000000022400000000000802240000000000000234000000000008023400000000000002440000000000080244000000000000025400000000000802540000000000000264000000000008026400000000000002740000000000080274000000000000028400000000000802840000000000000294000000000008029400000000000002a400000000000802a400000000000002b400000000000802b400000000000002c400000000000802c400000000000002d400000000000802d400000000000002e400000000000802e400000000000002f400000000000802f400000000000003040000000000040304000000000008030400000000000c030400000000000003140000000000040314000000000008031400000000000c031400000000000003240000000000040324000000000008032400000000000c032400000000000003340000000000040334000000000008033400000000000c033400000000000003440000000000040344000000000008034400000000000c034400000000000003540000000000040354000000000008035400000000000c035400000000000003640000000000040364000000000008036400000000000c036400000000000003740000000000040374000000000008037400000000000c037400000000000003840000000000040384000000000008038400000000000c0384000000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f00000000000000002d431cebe2361a3f2d431cebe2362a3f623255302aa9333f2d431cebe2363a3f', 100, 0, 24.75, 0.5, 24.75, 0, 0.4, 1795341505.069);


--
-- Data for Name: profile_key; Type: TABLE DATA; Schema: public; Owner: -
--



--
-- Data for Name: study; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study VALUES ('87568cc732624410b206cd113bf99701', 'Both slabs', '{"line": "test"}', 0, true, '{"track": {"pad_stiffness_n_per_m": 50000000.0}, "numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Both slabs", "labels": {"line": "test"}, "sweep": {"speed_kmh": [300.0], "slab": ["continuous", "discontinuous"], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}, "kind": "product"}, "keep_history": true}', 0, 1795341487.476, 1795341502.66, 1795341504.285, NULL, NULL, 2);
INSERT INTO public.study VALUES ('f4c8e8b7f35f45bba99d5f0663c5087c', 'A spectrum', '{}', 0, false, '{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "A spectrum", "sweep": {"speed_kmh": [250.0], "irregularity": {"kind": "spectrum", "percentile": [25.0], "wavelength_band_m": [{"min": 2.0, "max": 30.0}], "seed": 7}, "kind": "product"}}', 0, 1795341504.356, 1795341504.42, 1795341504.975, NULL, NULL, 3);
INSERT INTO public.study VALUES ('6d8d7a9f3d424ebabf92bce3ff15eebf', 'A measured profile', '{}', 0, false, '{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "A measured profile", "sweep": {"speed_kmh": [250.0], "irregularity": {"kind": "measured", "profile_id": "93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e"}, "kind": "product"}}', 0, 1795341505.094, 1795341505.17, 1795341505.792, NULL, NULL, 4);
INSERT INTO public.study VALUES ('745c5b76afd5485b8a6a25d79689dc45', 'Queued when the release ended', '{}', 0, false, '{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Queued when the release ended", "sweep": {"speed_kmh": [200.0], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}, "kind": "product"}}', 0, 1795341522.624, NULL, NULL, NULL, NULL, 5);


--
-- Data for Name: study_case; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study_case VALUES ('87568cc732624410b206cd113bf99701', 1, 0);
INSERT INTO public.study_case VALUES ('87568cc732624410b206cd113bf99701', 2, 1);
INSERT INTO public.study_case VALUES ('f4c8e8b7f35f45bba99d5f0663c5087c', 3, 0);
INSERT INTO public.study_case VALUES ('6d8d7a9f3d424ebabf92bce3ff15eebf', 4, 0);
INSERT INTO public.study_case VALUES ('745c5b76afd5485b8a6a25d79689dc45', 5, 0);


--
-- Data for Name: study_profile; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study_profile VALUES ('6d8d7a9f3d424ebabf92bce3ff15eebf', '93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e');


--
-- Data for Name: study_share; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study_share VALUES ('6d8d7a9f3d424ebabf92bce3ff15eebf', 1);


--
-- Data for Name: verification; Type: TABLE DATA; Schema: public; Owner: -
--



--
-- Data for Name: worker; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.worker VALUES ('host:28673', 1795341511.455);


--
-- Name: api_key_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.api_key_id_seq', 1, true);


--
-- Name: case_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.case_id_seq', 5, true);


--
-- Name: event_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.event_id_seq', 17, true);


--
-- Name: peak_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.peak_id_seq', 212, true);


--
-- Name: verification_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.verification_id_seq', 1, false);


--
-- Name: alembic_version alembic_version_pkc; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.alembic_version
    ADD CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num);


--
-- Name: api_key pk_api_key; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.api_key
    ADD CONSTRAINT pk_api_key PRIMARY KEY (id);


--
-- Name: case pk_case; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case"
    ADD CONSTRAINT pk_case PRIMARY KEY (id);


--
-- Name: event pk_event; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event
    ADD CONSTRAINT pk_event PRIMARY KEY (id);


--
-- Name: history pk_history; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.history
    ADD CONSTRAINT pk_history PRIMARY KEY (case_id);


--
-- Name: idempotency_key pk_idempotency_key; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.idempotency_key
    ADD CONSTRAINT pk_idempotency_key PRIMARY KEY (key);


--
-- Name: peak pk_peak; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT pk_peak PRIMARY KEY (id);


--
-- Name: profile pk_profile; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.profile
    ADD CONSTRAINT pk_profile PRIMARY KEY (id);


--
-- Name: profile_key pk_profile_key; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.profile_key
    ADD CONSTRAINT pk_profile_key PRIMARY KEY (profile_id, key_id);


--
-- Name: study pk_study; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study
    ADD CONSTRAINT pk_study PRIMARY KEY (id);


--
-- Name: study_case pk_study_case; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT pk_study_case PRIMARY KEY (study_id, case_id);


--
-- Name: study_profile pk_study_profile; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_profile
    ADD CONSTRAINT pk_study_profile PRIMARY KEY (study_id, profile_id);


--
-- Name: study_share pk_study_share; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_share
    ADD CONSTRAINT pk_study_share PRIMARY KEY (study_id, key_id);


--
-- Name: verification pk_verification; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.verification
    ADD CONSTRAINT pk_verification PRIMARY KEY (id);


--
-- Name: worker pk_worker; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.worker
    ADD CONSTRAINT pk_worker PRIMARY KEY (name);


--
-- Name: api_key uq_api_key_name; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.api_key
    ADD CONSTRAINT uq_api_key_name UNIQUE (name);


--
-- Name: case uq_case_digest_solver_version; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case"
    ADD CONSTRAINT uq_case_digest_solver_version UNIQUE (digest, solver_version);


--
-- Name: peak uq_peak_case_id_quantity_position; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT uq_peak_case_id_quantity_position UNIQUE (case_id, quantity, "position");


--
-- Name: ix_case_amplitude_mm_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_amplitude_mm_id ON public."case" USING btree (amplitude_mm, id);


--
-- Name: ix_case_charged; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_charged ON public."case" USING btree (charged_to, finished_at);


--
-- Name: ix_case_irregularity_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_irregularity_id ON public."case" USING btree (irregularity, id);


--
-- Name: ix_case_operator; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_operator ON public."case" USING btree (operator_key, state, priority, id);


--
-- Name: ix_case_percentile_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_percentile_id ON public."case" USING btree (percentile, id);


--
-- Name: ix_case_queue; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_queue ON public."case" USING btree (state, priority DESC, turn, id);


--
-- Name: ix_case_realisation_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_realisation_id ON public."case" USING btree (realisation, id);


--
-- Name: ix_case_seed_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_seed_id ON public."case" USING btree (seed, id);


--
-- Name: ix_case_slab_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_slab_id ON public."case" USING btree (slab, id);


--
-- Name: ix_case_solver_version_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_solver_version_id ON public."case" USING btree (solver_version, id);


--
-- Name: ix_case_spectrum_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_spectrum_id ON public."case" USING btree (spectrum, id);


--
-- Name: ix_case_speed_kmh_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_speed_kmh_id ON public."case" USING btree (speed_kmh, id);


--
-- Name: ix_case_wavelength_m_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_wavelength_m_id ON public."case" USING btree (wavelength_m, id);


--
-- Name: ix_case_wavelength_max_m_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_wavelength_max_m_id ON public."case" USING btree (wavelength_max_m, id);


--
-- Name: ix_case_wavelength_min_m_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_wavelength_min_m_id ON public."case" USING btree (wavelength_min_m, id);


--
-- Name: ix_event_study_id_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_event_study_id_id ON public.event USING btree (study_id, id);


--
-- Name: ix_idempotency_key_created_at; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_idempotency_key_created_at ON public.idempotency_key USING btree (created_at);


--
-- Name: ix_peak_by_maximum; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_maximum ON public.peak USING btree (quantity, maximum, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_mean; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_mean ON public.peak USING btree (quantity, mean, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_minimum; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_minimum ON public.peak USING btree (quantity, minimum, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_peak; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_peak ON public.peak USING btree (quantity, peak, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_rms; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_rms ON public.peak USING btree (quantity, rms, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_std; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_std ON public.peak USING btree (quantity, std, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_time_s; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_time_s ON public.peak USING btree (quantity, time_s, id, speed_kmh, percentile);


--
-- Name: ix_peak_by_track_position_m; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_by_track_position_m ON public.peak USING btree (quantity, track_position_m, id, speed_kmh, percentile);


--
-- Name: ix_peak_peak_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_peak_id ON public.peak USING btree (peak, id);


--
-- Name: ix_peak_position_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_position_id ON public.peak USING btree ("position", id);


--
-- Name: ix_peak_quantity_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_quantity_id ON public.peak USING btree (quantity, id);


--
-- Name: ix_peak_unit_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_unit_id ON public.peak USING btree (unit, id);


--
-- Name: ix_profile_created_at; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_profile_created_at ON public.profile USING btree (created_at);


--
-- Name: ix_profile_key_key_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_profile_key_key_id ON public.profile_key USING btree (key_id);


--
-- Name: ix_study_case_case_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_case_case_id ON public.study_case USING btree (case_id);


--
-- Name: ix_study_created_at; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_created_at ON public.study USING btree (created_at);


--
-- Name: ix_study_owner_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_owner_id ON public.study USING btree (owner_id);


--
-- Name: ix_study_profile_profile_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_profile_profile_id ON public.study_profile USING btree (profile_id);


--
-- Name: ix_study_share_key_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_share_key_id ON public.study_share USING btree (key_id);


--
-- Name: ix_verification_case_id_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_verification_case_id_id ON public.verification USING btree (case_id, id);


--
-- Name: ix_verification_state_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_verification_state_id ON public.verification USING btree (state, id);


--
-- Name: event fk_event_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event
    ADD CONSTRAINT fk_event_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- Name: history fk_history_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.history
    ADD CONSTRAINT fk_history_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id) ON DELETE CASCADE;


--
-- Name: peak fk_peak_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT fk_peak_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id) ON DELETE CASCADE;


--
-- Name: profile_key fk_profile_key_key_id_api_key; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.profile_key
    ADD CONSTRAINT fk_profile_key_key_id_api_key FOREIGN KEY (key_id) REFERENCES public.api_key(id);


--
-- Name: profile_key fk_profile_key_profile_id_profile; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.profile_key
    ADD CONSTRAINT fk_profile_key_profile_id_profile FOREIGN KEY (profile_id) REFERENCES public.profile(id) ON DELETE CASCADE;


--
-- Name: study_case fk_study_case_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT fk_study_case_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id);


--
-- Name: study_case fk_study_case_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT fk_study_case_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- Name: study fk_study_owner_id_api_key; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study
    ADD CONSTRAINT fk_study_owner_id_api_key FOREIGN KEY (owner_id) REFERENCES public.api_key(id);


--
-- Name: study_profile fk_study_profile_profile_id_profile; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_profile
    ADD CONSTRAINT fk_study_profile_profile_id_profile FOREIGN KEY (profile_id) REFERENCES public.profile(id);


--
-- Name: study_profile fk_study_profile_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_profile
    ADD CONSTRAINT fk_study_profile_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- Name: study_share fk_study_share_key_id_api_key; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_share
    ADD CONSTRAINT fk_study_share_key_id_api_key FOREIGN KEY (key_id) REFERENCES public.api_key(id);


--
-- Name: study_share fk_study_share_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_share
    ADD CONSTRAINT fk_study_share_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- Name: verification fk_verification_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.verification
    ADD CONSTRAINT fk_verification_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id) ON DELETE CASCADE;


--
-- PostgreSQL database dump complete
--

\unrestrict arqrpe4dpw5mYIqIcGOKRGZwXvTDnXdLDKB2xwH9k5dB8AiehWpuXtAMONyui6E

